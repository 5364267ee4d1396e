// `render --hashes` and `verify` from the shell.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/command_run.h"

namespace pentimento::test {
namespace {

TEST(CommandVerify, TellsWhetherAReplayIsTheRecordedOne) {
  Workplace place;
  const Ran recorded = place.run("render a.jsonl --hashes a.hashes.gz --json");
  ASSERT_EQ(recorded.code, 0) << recorded.err;
  EXPECT_EQ(nlohmann::json::parse(recorded.out)["outputs"][0]["file"], "a.hashes.gz");
  const Ran same = place.run("verify a.jsonl a.hashes.gz");
  EXPECT_EQ(same.code, 0) << same.err;
  EXPECT_NE(same.out.find("equal: "), std::string::npos);
  const Ran other = place.run("verify a.jsonl a.hashes.gz --set model.brush_push=0.3 --json");
  EXPECT_EQ(other.code, 1) << other.err;
  EXPECT_FALSE(nlohmann::json::parse(other.out)["equal"].get<bool>());
  EXPECT_EQ(place.run("verify a.jsonl gone").code, 5);
  EXPECT_EQ(place.run("verify a.jsonl a.jsonl").code, 3);
  EXPECT_EQ(place.run("verify a.jsonl").code, 2);
}

}  // namespace
}  // namespace pentimento::test
