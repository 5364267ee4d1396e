#include <gtest/gtest.h>

#include "tests/cli/command_run.h"

namespace pentimento::test {
namespace {

TEST(CommandLine, ThatAFileNamesLeavesOutWhatChangesNoFile) {
  const Workplace place;
  const Ran ran = place.run(
      "render --threads 2 a.jsonl --memory-limit 1G --scratch . --quiet --no-clobber "
      "--json --progress none --output=b.png -oc.png --at 0.5 --output d.png --width 20 "
      "-o 'it is.png'");
  ASSERT_EQ(ran.code, 0) << ran.err;
  for (const auto& [file, word] : {std::pair{"b.png", "b.png"},
                                   {"c.png", "c.png"},
                                   {"d.png", "d.png"},
                                   {"'it is.png'", "'it is.png'"}})
    EXPECT_EQ(json_member(place.run(std::string("info --json ").append(file)).out, "command"),
              std::string("pentimento render a.jsonl --at 0.5 --width 20 -o ").append(word));
}

}  // namespace
}  // namespace pentimento::test
