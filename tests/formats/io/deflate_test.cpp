#include "formats/io/deflate.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <random>

namespace pentimento {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes made_up_bytes(std::size_t n, bool noise) {
  std::mt19937 random(3);
  Bytes bytes(n);
  for (std::size_t i = 0; i < n; ++i)
    bytes[i] = static_cast<std::uint8_t>(noise ? random() : i / 100);
  return bytes;
}

/// zlib's own reading of a whole zlib stream.
Bytes inflated(const Bytes& stream, std::size_t size) {
  Bytes out(size + 1);
  uLongf n = static_cast<uLongf>(out.size());
  EXPECT_EQ(uncompress(out.data(), &n, stream.data(), static_cast<uLong>(stream.size())), Z_OK);
  out.resize(n);
  return out;
}

TEST(Deflate, ZlibReadsTheStream) {
  for (const int level : {1, 6})
    for (const bool noise : {false, true})
      for (const std::size_t n : {0u, 1u, 1000u, 65536u, 3000000u}) {
        const Bytes bytes = made_up_bytes(n, noise);
        EXPECT_EQ(inflated(zlib_stream(bytes, level), n), bytes) << n << " at level " << level;
      }
}

TEST(Deflate, PiecesJoinToOneStream) {
  const Bytes bytes = made_up_bytes(300000, false);
  const std::span<const std::uint8_t> all(bytes);
  for (const Repeats repeats : {Repeats::kAny, Repeats::kRuns}) {
    Bytes stream = {0x78, 0x01};
    std::uint32_t adler = 1;
    for (const auto& [from, to] : {std::pair{0, 100000}, {100000, 100001}, {100001, 300000}}) {
      const auto piece =
          all.subspan(static_cast<std::size_t>(from), static_cast<std::size_t>(to - from));
      deflate_piece(piece, false, 1, repeats, stream);
      adler = adler32_joined(adler, adler32_of(piece), piece.size());
    }
    deflate_piece({}, true, 1, repeats, stream);
    EXPECT_EQ(adler, adler32_of(bytes));
    for (int shift = 24; shift >= 0; shift -= 8)
      stream.push_back(static_cast<std::uint8_t>(adler >> shift));
    EXPECT_EQ(inflated(stream, bytes.size()), bytes);
  }
}

TEST(Deflate, ChecksumsAreTheKnownOnes) {
  const Bytes bytes = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  EXPECT_EQ(crc32_of(0, bytes), 0xCBF43926u);  // the check value of CRC-32
  EXPECT_EQ(adler32_of(bytes), 0x091E01DEu);   // RFC 1950's algorithm, by hand
}

}  // namespace
}  // namespace pentimento
