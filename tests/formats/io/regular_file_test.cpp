#include "formats/io/regular_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

TEST(FirstBytes, AreThoseOfTheFile) {
  const test::Scratch scratch;
  test::spill(scratch.path("a"), "hello");
  EXPECT_EQ(*first_bytes(scratch.path("a"), 4), "hell");
  EXPECT_EQ(*first_bytes(scratch.path("a"), 8), "hello");
}

TEST(FirstBytes, OfAPipeAreNotWaitedFor) {
  const test::Scratch scratch;
  ASSERT_EQ(mkfifo(scratch.path("a").c_str(), 0600), 0);
  const auto bytes = first_bytes(scratch.path("a"), 4);
  ASSERT_FALSE(bytes);
  EXPECT_EQ(bytes.error().code, ErrorCode::kBadInput);
  EXPECT_EQ(bytes.error().message, scratch.path("a") + ": a pipe or a device, must be a file");
}

TEST(FirstBytes, OfWhatCannotBeReadAreAnError) {
  const test::Scratch scratch;
  EXPECT_EQ(first_bytes(scratch.path("none"), 4).error().code, ErrorCode::kIo);
  EXPECT_EQ(first_bytes(scratch.path(""), 4).error().code, ErrorCode::kIo);
}

}  // namespace
}  // namespace pentimento
