#include "formats/io/deflate.h"

#include <zlib.h>

#if PENTIMENTO_HAVE_ISAL
#include <isa-l/igzip_lib.h>
#endif

#include "core/check.h"

namespace pentimento {

namespace {

constexpr std::size_t kGrowth = std::size_t{64} << 10;
constexpr std::uint8_t kDeflate32k = 0x78;  // first byte of a zlib stream: deflate, window 32 KiB
constexpr std::uint8_t kFastest = 0x01;     // second byte: fastest level, header divisible by 31

#if PENTIMENTO_HAVE_ISAL
void deflate_isal(std::span<const std::uint8_t> bytes, bool last, std::vector<std::uint8_t>& out) {
  std::vector<std::uint8_t> work(ISAL_DEF_LVL1_DEFAULT);
  isal_zstream stream;
  isal_deflate_init(&stream);
  stream.level = 1;
  stream.level_buf = work.data();
  stream.level_buf_size = static_cast<std::uint32_t>(work.size());
  stream.end_of_stream = last ? 1 : 0;
  stream.flush = last ? NO_FLUSH : SYNC_FLUSH;
  stream.next_in = const_cast<std::uint8_t*>(bytes.data());  // the library only reads
  stream.avail_in = static_cast<std::uint32_t>(bytes.size());
  std::size_t used = out.size();
  do {
    out.resize(used + bytes.size() / 2 + kGrowth);
    stream.next_out = out.data() + used;
    stream.avail_out = static_cast<std::uint32_t>(out.size() - used);
    PENTIMENTO_CHECK(isal_deflate(&stream) == COMP_OK);
    used = out.size() - stream.avail_out;
  } while (stream.avail_out == 0);
  out.resize(used);
}
#endif

[[maybe_unused]] void deflate_zlib(std::span<const std::uint8_t> bytes, bool last, int level,
                                   std::vector<std::uint8_t>& out) {
  z_stream stream = {};
  constexpr int kRaw = -15;  // no zlib header, window 32 KiB
  PENTIMENTO_CHECK(deflateInit2(&stream, level, Z_DEFLATED, kRaw, 9, Z_DEFAULT_STRATEGY) == Z_OK);
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

void append_big_endian(std::uint32_t value, std::vector<std::uint8_t>& out) {
  for (int shift = 24; shift >= 0; shift -= 8)
    out.push_back(static_cast<std::uint8_t>(value >> shift));
}

}  // namespace

void deflate_piece(std::span<const std::uint8_t> bytes, bool last, int level,
                   std::vector<std::uint8_t>& out) {
#if PENTIMENTO_HAVE_ISAL
  if (level <= 1) {
    deflate_isal(bytes, last, out);
    return;
  }
#endif
  deflate_zlib(bytes, last, level, out);
}

std::vector<std::uint8_t> zlib_stream(std::span<const std::uint8_t> bytes, int level) {
  std::vector<std::uint8_t> out = {kDeflate32k, kFastest};
  deflate_piece(bytes, true, level, out);
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

std::string deflate_library() {
#if PENTIMENTO_HAVE_ISAL
  return "ISA-L";
#else
  return "zlib";
#endif
}

}  // namespace pentimento
