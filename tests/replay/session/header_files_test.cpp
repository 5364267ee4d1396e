#include "replay/session/header_files.h"

#include <gtest/gtest.h>

#include "tests/replay/small_job.h"

namespace pentimento {
namespace {

TEST(HeaderFiles, ThatCannotBeReadAreNamedWithTheLogAndItsLine) {
  const test::JobFolder folder(test::kSmallLog);
  folder.write("broken.png", "no picture");
  const std::string log = folder.path("a.jsonl");
  log::Header paper;
  paper.paper.texture = "broken.png";
  LogFiles files(log, false);
  const Result<BrushTable> broken = open_header_files(paper, files);
  ASSERT_FALSE(broken.ok());
  EXPECT_EQ(broken.error().code, ErrorCode::kBadInput);
  EXPECT_TRUE(broken.error().message.starts_with(log + ":1: " + folder.path("broken.png") + ": "))
      << broken.error().message;
  log::Header tip;
  tip.brushes.emplace_back().texture = "missing.png";
  const Result<BrushTable> missing = open_header_files(tip, files);
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().message,
            log + ":1: file \"missing.png\" cannot be found: No such file or directory");
  LogFiles piped("-", false);
  EXPECT_TRUE(open_header_files(tip, piped).error().message.starts_with("standard input:1: "));
}

TEST(HeaderFiles, OfTheProgramItselfNeedNoFile) {
  LogFiles files("a.jsonl", false);
  EXPECT_TRUE(open_header_files(log::Header(), files).ok());
  EXPECT_TRUE(files.paths().empty());
}

}  // namespace
}  // namespace pentimento
