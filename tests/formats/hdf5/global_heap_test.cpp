#include "formats/hdf5/global_heap.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <span>
#include <string>

namespace pentimento::hdf5 {
namespace {

/// Little endian, of `count` bytes.
std::string number(std::uint64_t value, int count) {
  std::string bytes;
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i));
  return bytes;
}

std::string header(std::uint64_t heap_bytes) {
  return "GCOL" + number(1, 4) + number(heap_bytes, 8);
}

/// An object of which only the header and `text` are there.
std::string object(int index, std::uint64_t size, const std::string& text = {}) {
  return number(static_cast<std::uint64_t>(index), 2) + number(1, 6) + number(size, 8) + text;
}

bool endless(const std::string& bytes) {
  return is_endless_heap(std::as_bytes(std::span(bytes)));
}

TEST(GlobalHeap, ASoundOneEnds) {
  // Header 16, an object of 3 + 5 bytes with its header of 16, free room of 24 bytes in all.
  EXPECT_FALSE(endless(header(64) + object(1, 3, std::string("abc\0\0\0\0\0", 8)) +
                       object(0, 24, std::string(8, '\0'))));
  EXPECT_FALSE(endless(header(16)));
  // Eight bytes of free room are too few for a header.
  EXPECT_FALSE(endless(header(40) + object(1, 0) + std::string(8, '\0')));
}

TEST(GlobalHeap, AnObjectWithoutRoomKeepsTheLibraryForEver) {
  EXPECT_TRUE(endless(header(4096) + object(0, 0)));
  // A text of no characters has a header, and takes its room.
  EXPECT_FALSE(endless(header(4096) + object(1, 0)));
}

TEST(GlobalHeap, AnObjectLargerThanTheHeapLeadsOutOfIt) {
  EXPECT_FALSE(endless(header(64) + object(1, 32, std::string(32, 'a'))));
  EXPECT_TRUE(endless(header(64) + object(1, 33, std::string(32, 'a'))));
  EXPECT_TRUE(endless(header(64) + object(0, 49, std::string(32, 'a'))));
  // Rounded up, this size is 0.
  EXPECT_TRUE(endless(header(64) + object(1, ~std::uint64_t{0})));
}

TEST(GlobalHeap, OfOneThatGoesOnTheBeginningIsLookedAt) {
  EXPECT_FALSE(endless(header(8192) + object(1, 4096, std::string(200, 'a'))));
  EXPECT_FALSE(endless(header(8192)));
  EXPECT_TRUE(endless(header(8192) + object(1, 8, std::string(8, 'a')) + object(0, 0)));
}

TEST(GlobalHeap, ASizeNearTheLargestNumberLeadsNowhere) {
  // The free room ends where sixteen bytes more are past the largest number.
  EXPECT_FALSE(endless(header(~std::uint64_t{0}) + object(0, ~std::uint64_t{0} - 16)));
}

TEST(GlobalHeap, OtherBytesAreNone) {
  EXPECT_FALSE(endless(""));
  EXPECT_FALSE(endless("GCOL"));
  EXPECT_FALSE(endless("HEAP" + header(4096).substr(4) + object(0, 0)));
}

}  // namespace
}  // namespace pentimento::hdf5
