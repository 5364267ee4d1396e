#include "replay/log/log_files.h"

#include <gtest/gtest.h>

#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

TEST(LogFiles, AreFoundBesideTheLogAndRememberedWithTheirHash) {
  const test::Scratch scratch;
  test::spill(scratch.path("x.png"), "hello");
  LogFiles files(scratch.path("log.jsonl"), false);
  const auto path = files.use("x.png");
  ASSERT_TRUE(path) << path.error().message;
  EXPECT_EQ(*path, scratch.path("x.png"));
  // echo -n hello | sha256sum
  EXPECT_EQ(files.hashes(),
            (std::map<std::string, std::string>{
                {"x.png", "2cf24dba5fb0a30e26e83b2ac5b9e29e1b161e5c1fa7425e73043362938b9824"}}));
  EXPECT_FALSE(files.use("none.png"));
  EXPECT_EQ(files.hashes().size(), 1u);
}

TEST(LogFiles, AHashIsThatOfAllOfALargeFile) {
  const test::Scratch scratch;
  std::string bytes;
  for (int i = 0; i < 200'000; ++i) bytes.push_back(static_cast<char>(i * 7));
  test::spill(scratch.path("x"), bytes);
  LogFiles files(scratch.path("log.jsonl"), false);
  ASSERT_TRUE(files.use("x"));
  EXPECT_EQ(files.hashes().at("x"),
            test::run("sha256sum " + scratch.path("x")).second.substr(0, 64));
}

TEST(LogFiles, LeaveTheFolderOnlyIfTheyMay) {
  const test::Scratch scratch;
  std::filesystem::create_directory(scratch.path("in"));
  test::spill(scratch.path("x"), "hello");
  EXPECT_FALSE(LogFiles(scratch.path("in/log.jsonl"), false).use("../x"));
  EXPECT_TRUE(LogFiles(scratch.path("in/log.jsonl"), true).use("../x"));
}

TEST(LogFiles, APictureIsDecodedBeforeAnyWork) {
  const test::Scratch scratch;
  test::spill(scratch.path("x.png"), "hello");
  EXPECT_TRUE(LogFiles(scratch.path("log"), false).use("x.png"));
  EXPECT_FALSE(LogFiles(scratch.path("log"), false).use_picture("x.png"));
  EXPECT_FALSE(LogFiles(scratch.path("log"), false).use_camera("x.png"));
}

}  // namespace
}  // namespace pentimento
