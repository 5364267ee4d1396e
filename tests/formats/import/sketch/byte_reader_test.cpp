#include "formats/import/sketch/byte_reader.h"

#include <gtest/gtest.h>

using namespace std::string_view_literals;

namespace pentimento::sketch {
namespace {

TEST(ByteReader, ReadsLittleEndianNumbers) {
  ByteReader in("a.bin", "\x01\x02\x01\x04\x03\x02\x01\xff\xff\xff\xff\x00\x00\x80\x3f"sv);
  EXPECT_EQ(in.u8("a"), 1);
  EXPECT_EQ(in.u16("b"), 0x0102);
  EXPECT_EQ(in.u32("c"), 0x01020304u);
  EXPECT_EQ(in.i32("d"), -1);
  EXPECT_EQ(in.f32("e"), 1.0f);
  EXPECT_TRUE(in.ok());
  EXPECT_EQ(in.left(), 0u);
}

TEST(ByteReader, KeepsTheFirstProblemAndGivesZeros) {
  ByteReader in("a.bin", "\x05\x01\x02"sv, 16);
  in.u8("head");
  EXPECT_EQ(in.u32("length"), 0u);
  EXPECT_EQ(in.u8("next"), 0);
  ASSERT_FALSE(in.ok());
  EXPECT_EQ(in.error().message,
            "a.bin: offset 17: length is cut short: 4 bytes are needed, 2 are left");
  EXPECT_EQ(in.error().code, ErrorCode::kBadInput);
}

TEST(ByteReader, RefusesCountsThatCannotBe) {
  ByteReader fits("a.bin", "\x02\x00\x00\x00....."sv);
  EXPECT_EQ(fits.count("points", 2), 2u);
  for (const std::string_view bytes : {"\x03\x00\x00\x00....."sv, "\xff\xff\xff\xff....."sv}) {
    ByteReader in("a.bin", bytes);
    EXPECT_EQ(in.count("points", 2), 0u);
    EXPECT_FALSE(in.ok());
  }
}

TEST(ByteReader, RefusesNumbersThatAreNotFinite) {
  for (const std::string_view bytes : {"\x00\x00\x80\x7f"sv, "\x00\x00\xc0\x7f"sv}) {
    ByteReader in("a.bin", bytes);
    EXPECT_EQ(in.f32("x"), 0);
    EXPECT_FALSE(in.ok());
  }
  ByteReader in("a.bin", "\x00\x00\x00\x00\x00\x00\xf0\x7f"sv);
  EXPECT_EQ(in.f64("x"), 0);
  EXPECT_FALSE(in.ok());
}

}  // namespace
}  // namespace pentimento::sketch
