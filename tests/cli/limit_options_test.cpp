// The limits of logs as options.

#include <gtest/gtest.h>

#include "tests/cli/command_run.h"

namespace pentimento::test {
namespace {

TEST(LimitOptions, RefuseALogThatAsksForMore) {
  const Workplace place;
  for (const std::string option : {"--limit stamps=2", "--limit move=2", "--limit colors=1",
                                   "--limit pigments=1", "--limit bytes=300", "--max-events 3"}) {
    const Ran ran = place.run("render a.jsonl -o a.png " + option);
    if (option == "--limit colors=1") {
      EXPECT_EQ(ran.code, 0) << "the log picks one: " << ran.err;
      continue;
    }
    EXPECT_EQ(ran.code, 4) << option << ran.err;
    EXPECT_EQ(lines_in(ran.err), 1U) << ran.err;
    EXPECT_NE(
        ran.err.find("the limit (" + option.substr(0, option.find_first_of("= 0123456789", 10))),
        std::string::npos)
        << "names the option that raises it: " << option << ran.err;
  }
}

TEST(LimitOptions, RefuseNamesAndNumbersThatAreNone) {
  const Workplace place;
  EXPECT_NE(place.run("validate a.jsonl --limit stamp=2").err.find("did you mean \"stamps\"?"),
            std::string::npos);
  for (const std::string wrong : {"stamps", "stamps=0", "stamps=x", "none=3"})
    EXPECT_EQ(place.run("render a.jsonl -o a.png --limit " + wrong).code, 2) << wrong;
}

}  // namespace
}  // namespace pentimento::test
