#include "formats/io/regular_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cerrno>

#include "tests/formats/faulty_disk.h"
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

TEST(FirstBytes, AreReadOnAfterASignal_NotAfterAnError) {
  const test::Scratch scratch;
  test::spill(scratch.path("a"), "hello");
  test::FaultyDisk disk;
  disk.plan("read", 1, {EINTR});
  disk.plan("read", 2, {0, 2});
  EXPECT_EQ(*first_bytes(scratch.path("a"), 4), "hell");
  disk.plan("read", 1, {EIO});
  EXPECT_EQ(first_bytes(scratch.path("a"), 4).error().message,
            scratch.path("a") + ": Input/output error");
}

}  // namespace
}  // namespace pentimento
