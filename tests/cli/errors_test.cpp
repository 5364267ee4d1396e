// Every exit code, in one line, with nothing written and old files as they were.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/cli/command_run.h"

namespace pentimento::test {
namespace {

/// The command fails with `code`, one line on standard error, and leaves `files` files.
void expect_failure(const Workplace& place, const std::string& arguments, int code,
                    std::size_t files) {
  const Ran ran = place.run(arguments);
  EXPECT_EQ(ran.code, code) << arguments << "\n" << ran.err;
  EXPECT_EQ(lines_in(ran.err), 1u) << ran.err;
  EXPECT_EQ(ran.err.substr(0, 12), "pentimento: ") << ran.err;
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(place.files(), files) << arguments;
}

TEST(CommandErrors, WrongUsageIsTwo) {
  const Workplace place;
  for (const char* wrong : {"",
                            "rendr",
                            "render",
                            "render a.jsonl",
                            "render a.jsonl -o a.jpg",
                            "render a.jsonl -o a.png --nonsense",
                            "render a.jsonl -o a.png --bit-depth 9",
                            "render a.jsonl -o a.png --threads x",
                            "render a.jsonl -o a.png --at x",
                            "render a.jsonl -o a.png --scheme wet",
                            "render a.jsonl -o a.png --aov blue",
                            "render a.jsonl -o a.png --progress loud",
                            "render a.jsonl -o a.png --memory-limit lots",
                            "render a.jsonl -o a.png --gravity 1,2",
                            "render a.jsonl -o a.png --gravity 1,2,9x",
                            "render a.jsonl -o a.png --white-point 1e9",
                            "render a.jsonl -o a.png --light 0,0,0",
                            "relight",
                            "compare a.png",
                            "validate",
                            "info"}) {
    expect_failure(place, wrong, 2, 1);
  }
}

TEST(CommandErrors, AReportIntoAFullDiskIsFive) {
  const Workplace place;
  EXPECT_EQ(place.run("info a.jsonl > /dev/full; (exit $?)").code, 5);
}

TEST(CommandErrors, AMisspeltNameGetsASuggestion) {
  const Workplace place;
  EXPECT_NE(place.run("rendr").err.find("\"render\""), std::string::npos);
  EXPECT_NE(place.run("render a.jsonl -o a.png --widht 3").err.find("\"--width\""),
            std::string::npos);
}

TEST(CommandErrors, BadInputIsThreeAndNamesTheLine) {
  Workplace place;
  place.write("bad.jsonl", kSmallLog + R"({"t":2,"type":"touch","phase":"down","x":0,"y":0,)" +
                               R"("pressure":1.7})" + "\n");
  const Ran ran = place.run("render bad.jsonl -o a.png");
  EXPECT_EQ(ran.code, 3);
  EXPECT_EQ(ran.err, "pentimento: bad.jsonl:12: pressure 1.7 is outside 0..1\n");
  expect_failure(place, "render bad.jsonl -o a.png", 3, 2);
  expect_failure(place, "relight bad.jsonl -o a.png", 3, 2);
}

TEST(CommandErrors, AnOldFileStaysAsItWas) {
  Workplace place;
  place.write("a.png", "old");
  place.write("bad.jsonl", "{}");
  EXPECT_EQ(place.run("render bad.jsonl -o a.png").code, 3);
  EXPECT_EQ(place.read("a.png"), "old");
  // The second file cannot be written, so the first must not be published.
  EXPECT_EQ(place.run("render a.jsonl -o a.png -o nowhere/b.png").code, 5);
  EXPECT_EQ(place.read("a.png"), "old");
  EXPECT_EQ(place.files(), 3u);
}

TEST(CommandErrors, NoClobberKeepsWhatIsThere) {
  Workplace place;
  place.write("a.png", "old");
  EXPECT_NE(place.run("render a.jsonl -o a.png --no-clobber").code, 0);
  EXPECT_EQ(place.read("a.png"), "old");
}

TEST(CommandErrors, OverALimitIsFour) {
  const Workplace place;
  expect_failure(place, "render a.jsonl -o a.png --memory-limit 1M", 4, 1);
  const Ran poster = place.run("render a.jsonl -o a.png --scale 32 --memory-limit 150M");
  EXPECT_EQ(poster.code, 4);
  for (const char* word : {"2560 x 1920", "--memory-limit", "--detail 16"})
    EXPECT_NE(poster.err.find(word), std::string::npos) << poster.err;
  expect_failure(place, "render a.jsonl -o a.png --max-events 5", 4, 1);
  expect_failure(place, "render a.jsonl -o a.png --max-steps 10", 4, 1);
  expect_failure(place, "render a.jsonl -o a.png --scale 30000", 4, 1);
}

TEST(CommandErrors, FailedWritingAndReadingIsFive) {
  const Workplace place;
  expect_failure(place, "render a.jsonl -o nowhere/a.png", 5, 1);
  expect_failure(place, "render none.jsonl -o a.png", 5, 1);
  const Ran full = place.run("render a.jsonl -o full.png", "ln -s /dev/full full.png &&");
  EXPECT_EQ(full.code, 5) << full.err;
  EXPECT_EQ(lines_in(full.err), 1u);
}

/// `moves` tenths of a second of brushing to and fro.
std::string brushing(int moves) {
  std::string log = kSmallLog;
  log += R"({"t":2,"type":"slider","name":"size","value":0.2})"
         "\n";
  log += R"({"t":2,"type":"touch","phase":"down","x":0.1,"y":0.1})"
         "\n";
  for (int i = 1; i <= moves; ++i)
    log += fmt::format(R"({{"t":{},"type":"touch","phase":"move","x":{},"y":0.2}})"
                       "\n",
                       2 + 0.1 * i, i % 2 == 0 ? 0.1 : 0.3);
  return log;
}

TEST(CommandErrors, ASignalIsSeventyFiveAndLeavesNothing) {
  Workplace place;
  place.write("long.jsonl", brushing(1000));  // of which a second is never enough
  for (const char* signal : {"INT", "TERM"}) {
    const Ran ran = place.run("render long.jsonl -o a.png --scale 4", signalled(signal, "1"));
    EXPECT_EQ(ran.code, 75) << ran.err;
    EXPECT_EQ(place.files(), 2u);
  }
}

TEST(CommandErrors, ASignalEndsTheSurveyBeforeAPosterToo) {
  Workplace place;
  place.write("long.jsonl", brushing(20000));  // surveyed in some 20 s
  for (const char* what : {"", " --dry-run"}) {
    const Ran ran = place.run(std::string("render long.jsonl -o a.png --scale 4").append(what),
                              signalled("INT", "1"));
    EXPECT_EQ(ran.code, 75) << ran.err;
    EXPECT_EQ(lines_in(ran.err), 1u) << ran.err;
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(place.files(), 2u);
  }
}

TEST(CommandErrors, EveryCutOfALogIsThreeInOneLine) {
  Workplace place;
  // Cuts in the header, in events, between and within tokens; the reader's own test does them all.
  for (std::size_t cut = 0; cut < kSmallLog.size() - 1; cut += 37) {
    const bool whole_lines = cut > 0 && kSmallLog[cut - 1] == '\n';
    place.write("cut.jsonl", kSmallLog.substr(0, cut));
    const Ran ran = place.run("validate cut.jsonl");
    EXPECT_EQ(ran.code, whole_lines || kSmallLog[cut] == '\n' ? 0 : 3) << cut;
    EXPECT_EQ(lines_in(ran.err), ran.code == 3 ? 1u : 0u) << ran.err;
  }
}

TEST(CommandErrors, SalvageReplaysTheWholeEvents) {
  Workplace place;
  place.write("cut.jsonl", kSmallLog.substr(0, kSmallLog.size() - 5));
  EXPECT_EQ(place.run("render cut.jsonl -o a.png").code, 3);
  const Ran ran = place.run("render cut.jsonl -o a.png --salvage");
  EXPECT_EQ(ran.code, 0);
  EXPECT_NE(ran.err.find("line 11"), std::string::npos) << ran.err;
}

TEST(CommandErrors, AFileThatTheLogNamesIsReadBeforeAnyWork) {
  Workplace place;
  place.write("load.jsonl", kSmallLog + R"({"t":2,"type":"load","file":"x.png"})" + "\n");
  expect_failure(place, "render load.jsonl -o a.png", 3, 2);  // not there
  place.write("x.png", "not a picture");
  expect_failure(place, "render load.jsonl -o a.png", 3, 3);
  EXPECT_EQ(place.run("render load.jsonl -o a.png").err.substr(0, 27),
            "pentimento: load.jsonl:12: ");
}

TEST(CommandErrors, ALogStaysInItsFolder) {
  Workplace place;
  place.write("out.jsonl", kSmallLog + R"({"t":2,"type":"load","file":"../x.png"})" + "\n");
  expect_failure(place, "render out.jsonl -o a.png", 3, 2);
}

// The libraries that read pictures have words of their own, which nobody is to see.
TEST(CommandErrors, ABrokenPictureOfEachKindIsOneLine) {
  Workplace place;
  place.write("load.jsonl", kSmallLog + R"({"t":2,"type":"load","file":"x"})" + "\n");
  const std::string corpus = std::string(PENTIMENTO_SOURCE_DIR) + "/tests/corpus/fuzz/picture/";
  for (const char* name : {"small.jpg", "flat.hdr", "small.tiff", "rgba.png", "aov-half.exr"}) {
    const std::string whole = slurp(corpus + name);
    ASSERT_FALSE(whole.empty()) << name;
    for (const std::size_t cut : {whole.size() / 2, whole.size() - 1}) {
      place.write("x", whole.substr(0, cut));
      expect_failure(place, "render load.jsonl -o a.png", 3, 3);
    }
  }
}

}  // namespace
}  // namespace pentimento::test
