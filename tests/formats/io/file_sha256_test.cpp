#include "formats/io/file_sha256.h"

#include <gtest/gtest.h>

#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

TEST(FileSha256, IsThatOfSha256sum) {
  const test::Scratch scratch;
  test::spill(scratch.path("long"), std::string(200'001, 'x'));  // three pieces and a bit
  test::spill(scratch.path("empty"), "");
  for (const char* name : {"long", "empty"}) {
    const Result<std::string> hash = file_sha256(scratch.path(name));
    ASSERT_TRUE(hash.ok());
    EXPECT_EQ(*hash, test::run("sha256sum " + scratch.path(name)).second.substr(0, 64)) << name;
  }
}

TEST(FileSha256, NeedsAFileThatCanBeRead) {
  const test::Scratch scratch;
  for (const std::string& path : {scratch.path("missing"), scratch.path("")}) {
    const Result<std::string> hash = file_sha256(path);
    ASSERT_FALSE(hash.ok()) << path;
    EXPECT_EQ(hash.error().code, ErrorCode::kIo);
    EXPECT_EQ(hash.error().message, path + ": cannot be read");
  }
}

}  // namespace
}  // namespace pentimento
