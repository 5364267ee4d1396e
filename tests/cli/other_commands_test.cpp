#include <gtest/gtest.h>

#include "tests/cli/command_run.h"

namespace pentimento::test {
namespace {

TEST(CommandHelp, StandsOnStandardOutputWithExamplesFirst) {
  const Workplace place;
  for (const char* command : {"", "render ", "relight ", "info ", "validate ", "compare "}) {
    const Ran ran = place.run(command + std::string("--help"));
    EXPECT_EQ(ran.code, 0);
    EXPECT_EQ(ran.err, "");
    const std::size_t examples = ran.out.find("Examples:");
    const std::size_t options = ran.out.find("Options:");
    ASSERT_NE(examples, std::string::npos) << command;
    EXPECT_LT(examples, options) << command;
  }
  EXPECT_EQ(place.run("--version").out.substr(0, 11), "pentimento ");
}

TEST(CommandRelight, InTheSameLightItIsTheRender) {
  const Workplace place;
  ASSERT_EQ(place.run("render a.jsonl -o a.png -o a.exr -o a.h5 --width 100 --float").code, 0);
  ASSERT_EQ(place.run("relight a.h5 -o b.png -o b.exr --width 100 --float").code, 0);
  EXPECT_EQ(place.run("compare a.png b.png").code, 0);
  EXPECT_EQ(place.run("compare a.exr b.exr").code, 0);
}

TEST(CommandRelight, OtherLightIsAnotherPicture) {
  const Workplace place;
  ASSERT_EQ(place.run("render a.jsonl -o a.png -o a.h5").code, 0);
  ASSERT_EQ(place.run("relight a.h5 -o b.png --light=1,0.2,0.3 --exposure -0.5").code, 0);
  EXPECT_EQ(place.run("compare a.png b.png").code, 1);
  EXPECT_EQ(place.run("relight a.h5 -o b.h5").code, 2);
}

TEST(CommandCompare, ThresholdsDecide) {
  const Workplace place;
  ASSERT_EQ(place.run("render a.jsonl -o a.png").code, 0);
  ASSERT_EQ(place.run("render a.jsonl -o b.png --exposure 0.01").code, 0);
  EXPECT_EQ(place.run("compare a.png a.png").code, 0);
  EXPECT_EQ(place.run("compare a.png b.png").code, 1);
  EXPECT_EQ(place.run("compare a.png b.png --max 0.1").code, 0);
  EXPECT_EQ(place.run("compare a.png b.png --max 0.1 --psnr 90").code, 1);
  const Ran json = place.run("compare a.png b.png --json");
  EXPECT_EQ(json.code, 1);
  EXPECT_EQ(json_member(json.out, "kind"), "picture");
}

TEST(CommandInfo, KnowsLogsDumpsAndPictures) {
  const Workplace place;
  ASSERT_EQ(place.run("render a.jsonl -o a.png -o a.exr -o a.h5").code, 0);
  const Ran log = place.run("info a.jsonl --json");
  EXPECT_EQ(json_member(log.out, "kind"), "log");
  EXPECT_EQ(json_member(log.out, "strokes"), "2");
  EXPECT_EQ(json_member(log.out, "steps"), "55");
  const std::string sha = json_member(log.out, "log_sha256");
  for (const char* file : {"a.png", "a.exr", "a.h5"}) {
    const Ran output = place.run("info --json " + std::string(file));
    EXPECT_EQ(output.code, 0) << output.err;
    EXPECT_EQ(json_member(output.out, "log_sha256"), sha) << file;
    EXPECT_NE(output.out.find("pentimento render a.jsonl"), std::string::npos) << file;
  }
}

TEST(CommandValidate, GivesAVerdictPerLog) {
  Workplace place;
  place.write("b.jsonl", "{}\n");
  EXPECT_EQ(place.run("validate a.jsonl").code, 0);
  const Ran both = place.run("validate a.jsonl b.jsonl --json");
  EXPECT_EQ(both.code, 3);
  EXPECT_EQ(both.err, "");
  EXPECT_NE(both.out.find("\"valid\":true"), std::string::npos);
  EXPECT_NE(both.out.find("\"valid\":false"), std::string::npos);
}

}  // namespace
}  // namespace pentimento::test
