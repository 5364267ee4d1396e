#include "formats/checkpoint/archive.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace pentimento::checkpoint {
namespace {

TEST(Archive, ReadsWhatItWrote) {
  ArchiveWriter to;
  to.flag(true);
  to.u32(7);
  to.i64(-9);
  to.f32(0.1f);
  to.f64(-0.0);
  to.text("blue");
  const std::array<float, 3> values = {1, 2, 3};
  to.list(std::span<const float>(values));
  ArchiveReader from(to.bytes());
  EXPECT_TRUE(from.flag());
  EXPECT_EQ(from.u32(), 7u);
  EXPECT_EQ(from.i64(), -9);
  EXPECT_EQ(from.f32(), 0.1f);
  EXPECT_TRUE(std::signbit(from.f64()));
  EXPECT_EQ(from.text(), "blue");
  EXPECT_EQ(from.list<float>(), (std::vector<float>{1, 2, 3}));
  EXPECT_TRUE(from.complete());
}

TEST(Archive, BytesAreLittleEndianAndWithoutGaps) {
  ArchiveWriter to;
  to.flag(true);
  to.u32(0x01020304);
  EXPECT_EQ(to.bytes(), std::string("\x01\x04\x03\x02\x01", 5));
}

TEST(Archive, CutAnywhereItHasAProblemAndGivesNothing) {
  ArchiveWriter to;
  to.text("blue");
  to.u64(3);
  for (std::size_t size = 0; size < to.bytes().size(); ++size) {
    ArchiveReader from(std::string_view(to.bytes()).substr(0, size));
    from.text();
    from.u64();
    EXPECT_EQ(from.u64(), 0u);
    EXPECT_FALSE(from.complete()) << size;
  }
  ArchiveReader longer(to.bytes());
  longer.text();
  EXPECT_FALSE(longer.complete()) << "a number is left";
}

TEST(Archive, AListIsGivenMemoryOnlyForValuesThatAreThere) {
  ArchiveWriter to;
  to.u64(std::numeric_limits<std::uint64_t>::max());
  ArchiveReader from(to.bytes());
  EXPECT_TRUE(from.list<double>().empty());
  EXPECT_FALSE(from.ok());
}

TEST(Archive, RefusesNumbersThatAreNotFiniteAndFlagsThatAreNone) {
  for (const float bad : {std::numeric_limits<float>::infinity(), std::nanf("")}) {
    ArchiveWriter to;
    to.f32(bad);
    ArchiveReader from(to.bytes());
    from.f32();
    EXPECT_FALSE(from.ok());
  }
  ArchiveReader flag(std::string_view("\x02", 1));
  flag.flag();
  EXPECT_FALSE(flag.ok());
}

}  // namespace
}  // namespace pentimento::checkpoint
