#include "formats/log/stream/resolve.h"

#include <gtest/gtest.h>

#include "tests/formats/log/log_text.h"

namespace pentimento::log {
namespace {

namespace fs = std::filesystem;

class ResolveFile : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_.path() / "log/sub");
    folder_.write("log/a.jsonl", "");
    folder_.write("log/sub/tip.png", "tip");
    folder_.write("secret.png", "secret");
    fs::create_symlink("../secret.png", folder_.path() / "log/out.png");
    fs::create_symlink("sub/tip.png", folder_.path() / "log/in.png");
    fs::create_directory_symlink("..", folder_.path() / "log/up");
  }
  std::string message(const std::string& name, bool allow = false) {
    const auto result = resolve_file(folder_.file("log/a.jsonl"), name, allow);
    return result.ok() ? "" : result.error().message;
  }
  TemporaryFolder folder_;
};

TEST_F(ResolveFile, FindsFilesRelativeToTheLog) {
  const auto result = resolve_file(folder_.file("log/a.jsonl"), "sub/tip.png", false);
  ASSERT_TRUE(result.ok()) << result.error().message;
  EXPECT_EQ(*result, fs::canonical(folder_.path() / "log/sub/tip.png"));
  EXPECT_EQ(message("in.png"), "");
}

TEST_F(ResolveFile, RefusesEveryWayOut) {
  EXPECT_EQ(message("../secret.png"), R"(file "../secret.png" leaves the log's folder)");
  EXPECT_EQ(message("sub/../sub/tip.png"), R"(file "sub/../sub/tip.png" leaves the log's folder)");
  EXPECT_EQ(message("/etc/passwd"), R"(file "/etc/passwd" is an absolute path)");
  EXPECT_EQ(message("out.png"), R"(file "out.png" leaves the log's folder by a link)");
  EXPECT_EQ(message("up/secret.png"), R"(file "up/secret.png" leaves the log's folder by a link)");
}

TEST_F(ResolveFile, AllowsThemOnRequest) {
  EXPECT_EQ(message("../secret.png", true), "");
  EXPECT_EQ(message(folder_.file("secret.png"), true), "");
  EXPECT_EQ(message("out.png", true), "");
}

TEST_F(ResolveFile, WantsAnExistingFile) {
  EXPECT_EQ(message("none.png"), R"(file "none.png" cannot be found: No such file or directory)");
  EXPECT_EQ(message("sub"), R"(file "sub" is not a regular file)");
  EXPECT_EQ(message(""), R"(file "" is empty)");
}

}  // namespace
}  // namespace pentimento::log
