#include "replay/output/input_guard.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

class InputGuard : public testing::Test {
 protected:
  InputGuard() {
    test::spill(path("a.jsonl"), "log");
    test::spill(path("b.png"), "another");
  }
  std::string path(const std::string& name) const { return scratch_.path(name); }
  Result<void> check(const std::string& output) const {
    return check_inputs_stay({path("b.png"), path(output)}, {{path("a.jsonl"), "the log"}});
  }
  test::Scratch scratch_;
};

TEST_F(InputGuard, RefusesAnInputUnderAnyName) {
  std::filesystem::create_symlink(path("a.jsonl"), path("link.png"));
  std::filesystem::create_hard_link(path("a.jsonl"), path("hard.png"));
  for (const char* name : {"a.jsonl", "./a.jsonl", "link.png", "hard.png"}) {
    const Result<void> checked = check(name);
    ASSERT_FALSE(checked.ok()) << name;
    EXPECT_EQ(checked.error().code, ErrorCode::kUsage);
    EXPECT_EQ(checked.error().message, "-o " + path(name) + ": would replace the log");
  }
}

TEST_F(InputGuard, LetsOtherFilesAndDevicesBe) {
  EXPECT_TRUE(check("b.png").ok());
  EXPECT_TRUE(check("new.png").ok());
  EXPECT_TRUE(check_inputs_stay({"/dev/null"}, {{"/dev/null", "the log"}, {"", "nothing"}}).ok());
}

TEST_F(InputGuard, RefusesOneFileUnderTwoNames) {
  std::filesystem::create_symlink("new.png", path("link.png"));
  const Result<void> twice = check_outputs_differ({path("link.png"), path("new.png")});
  ASSERT_FALSE(twice.ok());
  EXPECT_EQ(twice.error().code, ErrorCode::kUsage);
  EXPECT_EQ(twice.error().message,
            "-o " + path("new.png") + ": is the same file as " + path("link.png"));
  EXPECT_TRUE(check_outputs_differ({path("b.png"), path("new.png"), path("b.png")}).ok());
}

TEST(InputGuardNames, ARenderReadsItsLogItsDumpItsLightAndWhatTheLogNames) {
  const test::Scratch scratch;
  test::spill(scratch.path("paper.png"), "paper");
  RenderJob job;
  job.log = scratch.path("a.jsonl");
  job.from = "s.h5";
  job.light.environment = "sky.exr";
  LogFiles files(job.log, false);
  ASSERT_TRUE(files.use("paper.png").ok());
  std::string told;
  for (const InputFile& input : files_read_by(job, files)) told += input.what + "; ";
  EXPECT_EQ(told,
            "the log; the state of --from; the picture of --environment; \"paper.png\", which the "
            "log names; ");
}

}  // namespace
}  // namespace pentimento
