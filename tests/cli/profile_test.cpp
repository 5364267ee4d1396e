#include <gtest/gtest.h>

#include "tests/cli/command_run.h"

namespace pentimento::test {
namespace {

TEST(CommandProfile, IsWrittenShownAndMindedByCompare) {
  const Workplace place;
  ASSERT_EQ(place.run("render a.jsonl -o a.h5 -o a.png -o a.exr --profile display-p3").code, 0);
  const Ran png = place.run("info a.png --json"), exr = place.run("info a.exr");
  EXPECT_NE(png.out.find("\"profile\":\"Display P3\""), std::string::npos) << png.out;
  EXPECT_NE(png.out.find("\"profile\":\"display-p3\""), std::string::npos);  // of the provenance
  EXPECT_NE(exr.out.find("colours: Display P3 primaries"), std::string::npos) << exr.out;
  ASSERT_EQ(place.run("relight a.h5 -o again.png --profile display-p3").code, 0);
  EXPECT_EQ(place.run("compare a.png again.png").code, 0);
  ASSERT_EQ(place.run("relight a.h5 -o srgb.png").code, 0);
  const Ran compared = place.run("compare a.png srgb.png --rms 0.01");
  EXPECT_EQ(compared.code, 0) << compared.out;
  EXPECT_NE(compared.out.find("Display P3 against sRGB"), std::string::npos) << compared.out;
  EXPECT_EQ(place.run("render a.jsonl -o b.png --profile cmyk").code, 2);
}

TEST(CommandDither, DependsOnNeitherThreadsNorTiles) {
  const Workplace place;
  ASSERT_EQ(place.run("render a.jsonl -o a.h5 -o a.png --dither on --threads 1").code, 0);
  for (const char* how : {"--threads 2", "--tile 16", "--threads 7 --tile 48"}) {
    ASSERT_EQ(place.run(std::string("relight a.h5 -o b.png --dither on ").append(how)).code, 0);
    EXPECT_EQ(place.run("compare a.png b.png").code, 0) << how;
  }
  EXPECT_NE(place.run("info a.png").out.find("dither                   on"), std::string::npos);
  ASSERT_EQ(place.run("relight a.h5 -o plain.png").code, 0);
  EXPECT_EQ(place.run("compare a.png plain.png").code, 1);
  EXPECT_EQ(place.run("compare a.png plain.png --max 0.008").code, 0);  // two codes
  ASSERT_EQ(place.run("relight a.h5 -o wide.png --bit-depth 16 --dither on").code, 0);
  EXPECT_NE(place.run("info wide.png").out.find("dither                   off"), std::string::npos);
}

}  // namespace
}  // namespace pentimento::test
