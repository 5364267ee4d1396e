#include "replay/output/output_claim.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

TEST(OutputClaim, IsMadeByOneRunAtATime) {
  const test::Scratch scratch;
  const std::string picture = scratch.path("a.png"), dump = scratch.path("a.h5");
  {
    const Result<OutputClaim> first = OutputClaim::take({picture}, {picture}, {});
    ASSERT_TRUE(first.ok());
    const Result<OutputClaim> second = OutputClaim::take({dump, picture}, {dump, picture}, {});
    ASSERT_FALSE(second.ok());
    EXPECT_EQ(second.error().code, ErrorCode::kUsage);
    EXPECT_TRUE(OutputClaim::take({dump}, {dump}, {}).ok()) << "a refused claim holds nothing";
  }
  EXPECT_TRUE(OutputClaim::take({picture}, {picture}, {}).ok());
  EXPECT_EQ(scratch.files(), 0U);
}

TEST(OutputClaim, RefusesInputsAndFilesWithTwoNames) {
  const test::Scratch scratch;
  const std::string log = scratch.path("a.jsonl"), link = scratch.path("link.png");
  test::spill(log, "log");
  std::filesystem::create_symlink("new.png", link);
  EXPECT_FALSE(OutputClaim::take({log}, {log}, {{log, "the log"}}).ok());
  const std::vector<std::string> twice = {link, scratch.path("new.png")};
  const Result<OutputClaim> claim = OutputClaim::take(twice, twice, {});
  ASSERT_FALSE(claim.ok());
  EXPECT_EQ(claim.error().message, "-o " + twice[1] + ": is the same file as " + link);
}

TEST(OutputClaim, LeavesPipesAndDevicesAlone) {
  EXPECT_TRUE(OutputClaim::take({"-", "/dev/null"}, {"-", "/dev/null"}, {}).ok());
}

}  // namespace
}  // namespace pentimento
