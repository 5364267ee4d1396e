#include "replay/commands/validate.h"

#include <gtest/gtest.h>

#include "tests/replay/small_job.h"

namespace pentimento {
namespace {

TEST(ValidateLog, TellsTheFilesThatALogNames) {
  std::string log = test::kSmallLog;
  log.replace(log.find("\"palette\""), 0, R"("paper":{"texture":"p.png"},)");
  const test::JobFolder folder(log + R"({"t":2,"type":"load","file":"l.png"})" + "\n");
  const test::JobFolder other;
  test::rendered(other.job({"p.png"}));
  const std::string picture = test::slurp(other.path("p.png"));
  EXPECT_FALSE(validate_log(folder.path("a.jsonl"), {}));  // neither is there
  folder.write("p.png", picture);
  EXPECT_FALSE(validate_log(folder.path("a.jsonl"), {}));
  folder.write("l.png", picture);
  const auto facts = validate_log(folder.path("a.jsonl"), {});
  ASSERT_TRUE(facts) << facts.error().message;
  const std::string hash = test::run("sha256sum " + folder.path("p.png")).second.substr(0, 64);
  EXPECT_EQ(facts->files, (std::map<std::string, std::string>{{"l.png", hash}, {"p.png", hash}}));
  EXPECT_EQ(facts->steps, 91);
  EXPECT_EQ(facts->pigments, (std::vector<std::string>{"blue", "red", "#e0c020"}));
}

TEST(ValidateLog, CountsWhatIsUndoneInTheEnd) {
  const std::string undo = R"({"t":2,"type":"undo"})"
                           "\n";
  const test::JobFolder folder(test::kSmallLog + undo + undo + undo +
                               R"({"t":2,"type":"redo"})"
                               "\n");
  const auto facts = validate_log(folder.path("a.jsonl"), {});
  ASSERT_TRUE(facts) << facts.error().message;
  EXPECT_EQ(facts->undone, 1);
  EXPECT_EQ(facts->summary.strokes, 2);
}

}  // namespace
}  // namespace pentimento
