// `pentimento batch` and `batch-report` from the shell, with the real renderer.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/command_run.h"

namespace pentimento::test {
namespace {

TEST(CommandBatch, RendersJudgesAndReports) {
  Workplace place;
  place.write("bad.jsonl", "no log\n");
  place.write("m.jsonl",
              "{\"id\":\"well\",\"log\":\"a.jsonl\"}\n"
              "{\"id\":\"finer\",\"log\":\"a.jsonl\",\"options\":[\"--width\",\"40\"]}\n"
              "{\"id\":\"bad\",\"log\":\"bad.jsonl\",\"expect\":{\"exit\":3}}\n"
              "{\"id\":\"gone\",\"log\":\"gone.jsonl\"}\n");
  const Ran first =
      place.run("batch m.jsonl -o run --golden golden --update-golden begun --states");
  EXPECT_EQ(first.code, 1) << first.err;
  EXPECT_NE(first.out.find("gone: exit: exit code 5 instead of 0: pentimento: gone.jsonl"),
            std::string::npos)
      << first.out;
  EXPECT_NE(first.out.find("4 jobs, 4 rendered now, 1 failed"), std::string::npos) << first.out;
  // The state is the command's.
  const auto alone =
      nlohmann::json::parse(place.run("render a.jsonl -o alone.png --json --quiet").out);
  EXPECT_NE(place.read("golden/index.jsonl").find(alone["state_sha256"].get<std::string>()),
            std::string::npos);

  // A hundredth of a slider is seen, and the report says in which fields and where.
  std::string changed = kSmallLog;
  changed.replace(changed.find(R"("x":0.25,"y":0.2)"), 16, R"("x":0.2525,"y":0.2)");
  place.write("a.jsonl", changed);
  const Ran second = place.run("batch m.jsonl -o run --golden golden --states --json");
  EXPECT_EQ(second.code, 1);
  const auto report = nlohmann::json::parse(second.out);
  EXPECT_EQ(report["rendered"], 3) << "a missing log is tried again";
  EXPECT_EQ(report["rows"][0]["kind"], "state");
  bool depth = false;
  for (const auto& difference : report["rows"][0]["differences"])
    depth = depth || (difference["of"] == "state" && difference["name"] == "/fluid/depth" &&
                      difference["x"] >= 0);
  EXPECT_TRUE(depth);
  EXPECT_EQ(place.run("batch-report run --junit r.xml --html html --json").code, 1);
  EXPECT_NE(place.read("r.xml").find("name=\"finer\""), std::string::npos);
  EXPECT_TRUE(place.has("html/index.html"));
}

TEST(CommandBatch, RefusesWhatMakesNoSense) {
  Workplace place;
  place.write("m.jsonl", "{\"id\":\"well\",\"log\":\"a.jsonl\"}\n");
  for (const char* words :
       {"batch m.jsonl", "batch m.jsonl -o run --shard 4/3", "batch m.jsonl -o run --timeout soon",
        "batch m.jsonl -o run --update-golden why", "batch m.jsonl -o run --memory-budget much",
        "batch-report run --json --junit -"}) {
    const Ran ran = place.run(words);
    EXPECT_EQ(ran.code, 2) << words;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  }
  EXPECT_EQ(place.run("batch-report a.jsonl").code, 3);
  EXPECT_EQ(place.run("batch gone.jsonl -o run").code, 5);
}

}  // namespace
}  // namespace pentimento::test
