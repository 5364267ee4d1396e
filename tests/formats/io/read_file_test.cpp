#include "formats/io/read_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

TEST(ReadFile, ReadsAllOrSaysWhyNot) {
  const test::Scratch scratch;
  const std::string path = scratch.path("a");
  const std::string bytes((1 << 20) + 3, 'x');
  std::ofstream(path) << bytes;
  const auto all = read_file(path, 2 << 20);
  ASSERT_TRUE(all);
  EXPECT_EQ(*all, bytes);
  const auto large = read_file(path, 1 << 20);
  ASSERT_FALSE(large);
  EXPECT_EQ(large.error().code, ErrorCode::kLimit);
  const auto none = read_file(scratch.path("none"), 100);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::kIo);
  const auto folder = read_file(scratch.path(""), 100);
  ASSERT_FALSE(folder);
  EXPECT_EQ(folder.error().code, ErrorCode::kIo);
}

}  // namespace
}  // namespace pentimento
