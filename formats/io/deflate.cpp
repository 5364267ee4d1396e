#include "formats/io/deflate.h"

#include <zlib.h>

#include "core/base/check.h"
#include "core/base/require_memory.h"

namespace pentimento {

namespace {

constexpr std::size_t kGrowth = std::size_t{64} << 10;
constexpr std::uint8_t kDeflate32k = 0x78;  // first byte of a zlib stream: deflate, window 32 KiB
constexpr std::uint8_t kFastest = 0x01;     // second byte: fastest level, header divisible by 31

void append_big_endian(std::uint32_t value, std::vector<std::uint8_t>& out) {
  for (int shift = 24; shift >= 0; shift -= 8)
    out.push_back(static_cast<std::uint8_t>(value >> shift));
}

}  // namespace

void deflate_piece(std::span<const std::uint8_t> bytes, bool last, int level, Repeats repeats,
                   std::vector<std::uint8_t>& out) {
  z_stream stream = {};
  constexpr int kRaw = -15;  // no zlib header, window 32 KiB
  const int strategy = repeats == Repeats::kRuns ? Z_RLE : Z_DEFAULT_STRATEGY;
  require_memory(deflateInit2(&stream, level, Z_DEFLATED, kRaw, 9, strategy) == Z_OK);
  stream.next_in = const_cast<Bytef*>(bytes.data());  // the library only reads
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::size_t used = out.size();
  do {
    out.resize(used + bytes.size() / 2 + kGrowth);
    stream.next_out = out.data() + used;
    stream.avail_out = static_cast<uInt>(out.size() - used);
    PENTIMENTO_CHECK(deflate(&stream, last ? Z_FINISH : Z_SYNC_FLUSH) != Z_STREAM_ERROR);
    used = out.size() - stream.avail_out;
  } while (stream.avail_out == 0);
  deflateEnd(&stream);
  out.resize(used);
}

std::vector<std::uint8_t> zlib_stream(std::span<const std::uint8_t> bytes, int level) {
  std::vector<std::uint8_t> out = {kDeflate32k, kFastest};
  deflate_piece(bytes, true, level, Repeats::kAny, out);
  append_big_endian(adler32_of(bytes), out);
  return out;
}

std::uint32_t adler32_of(std::span<const std::uint8_t> bytes) {
  return static_cast<std::uint32_t>(adler32_z(1, bytes.data(), bytes.size()));
}

std::uint32_t adler32_joined(std::uint32_t first, std::uint32_t second, std::size_t second_bytes) {
  return static_cast<std::uint32_t>(
      adler32_combine(first, second, static_cast<z_off_t>(second_bytes)));
}

std::uint32_t crc32_of(std::uint32_t before, std::span<const std::uint8_t> bytes) {
  return static_cast<std::uint32_t>(crc32_z(before, bytes.data(), bytes.size()));
}

}  // namespace pentimento
