// What the options of pictures and light say, as the files that are written repeat it.

#include <gtest/gtest.h>

#include <algorithm>

#include "formats/image/read_image.h"
#include "tests/cli/command_run.h"

namespace pentimento::test {
namespace {

std::string light_of(const Workplace& place, const std::string& options) {
  const Ran ran = place.run("render a.jsonl -o a.png --width 20 " + options);
  EXPECT_EQ(ran.code, 0) << ran.err;
  return place.run("info a.png --json").out;
}

TEST(CommandLamp, HasThePlaceTheIntensityAndTheColourThatAreGiven) {
  const Workplace place;
  const std::string light = light_of(
      place, "--lamp dir:0,3,4 --lamp dir:0,0,1,0.25 --lamp pos:0.1,0.2,0.3,0.5,1,0.75,0.125");
  for (const auto& [key, value] : {std::pair{"light.direction", "0 0.6 0.8"},
                                   {"light.intensity", "0.75"},  // docs/cli.md
                                   {"light.color", "1 0.976 0.94"},
                                   {"light1.direction", "0 0 1"},
                                   {"light1.intensity", "0.25"},
                                   {"light2.position_m", "0.1 0.2 0.3"},
                                   {"light2.intensity", "0.5"},
                                   {"light2.color", "1 0.75 0.125"},
                                   {"light3.intensity", ""}})
    EXPECT_EQ(json_member(light, key), value) << key;
}

TEST(CommandLamp, TwiceAsStrongAddsAsMuchAgain) {
  // EXR is linear, so that three pictures tell the lamp from its surroundings.
  const Workplace place;
  ASSERT_EQ(place.run("render a.jsonl -o a.h5").code, 0);
  for (const char* strength : {"0.25", "0.5", "1"}) {
    const std::string file = std::string("l").append(strength).append(".exr");
    ASSERT_EQ(
        place.run("relight a.h5 --float --lamp dir:0,0,1," + std::string(strength) + " -o " + file)
            .code,
        0);
    EXPECT_EQ(json_member(place.run("info " + file + " --json").out, "light.intensity"), strength);
  }
  const auto quarter = read_image(place.path("l0.25.exr")),
             half = read_image(place.path("l0.5.exr")), whole = read_image(place.path("l1.exr"));
  ASSERT_TRUE(quarter && half && whole);
  double most = 0;
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 80; ++x) {
      const float a = quarter->find("G")->row(y)[x], b = half->find("G")->row(y)[x],
                  c = whole->find("G")->row(y)[x];
      // A quarter more, then a half more. Light of about 1 in float, through a shader's sums.
      EXPECT_NEAR(c - b, 2 * (b - a), 1e-5f) << x << "," << y;
      most = std::max(most, static_cast<double>(c - b));
    }
  EXPECT_GT(most, 0.1);  // it lights the canvas
}

TEST(CommandLight, DevelopsThePictureAsTheOptionsSay) {
  const Workplace place;
  const std::string light = light_of(
      place,
      "--light 0,3,4 --exposure -0.5 --varnish 0.25 --occlusion 0.5 --white-point 0.34,0.35 "
      "--tone-curve filmic");
  for (const auto& [key, value] : {std::pair{"light.direction", "0 0.6 0.8"},
                                   {"exposure_ev", "-0.5"},
                                   {"varnish", "0.25"},
                                   {"occlusion", "0.5"},
                                   {"white_point", "0.34 0.35"},
                                   {"tone_curve", "filmic"}})
    EXPECT_EQ(json_member(light, key), value) << key;
}

TEST(CommandLight, OptionsAreRefusedBeyondTheirRange) {
  const Workplace place;
  for (const char* wrong :
       {"--white-point 1666", "--white-point 25001", "--white-point 0.005,0.3",
        "--white-point 0.3,0.95", "--varnish 1.1", "--occlusion -0.1", "--crop 1.5,0,10,10",
        "--crop 0,0,10", "--lamp dir:1,1,1,-1", "--tile 15", "--tile 4097"})
    EXPECT_EQ(place.run(std::string("render a.jsonl -o a.png ").append(wrong)).code, 2) << wrong;
  std::string lamps;
  for (int i = 0; i < 8; ++i) lamps += " --lamp dir:0,0,1";
  EXPECT_EQ(place.run("render a.jsonl -o a.png" + lamps).code, 2);
  EXPECT_FALSE(place.has("a.png"));
}

}  // namespace
}  // namespace pentimento::test
