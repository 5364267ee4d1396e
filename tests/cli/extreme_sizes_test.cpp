// The smallest and the largest canvases and pictures: they work, or are refused in one line.

#include <gtest/gtest.h>

#include "tests/cli/command_run.h"

namespace pentimento::test {
namespace {

/// A stroke across a canvas of `width_m` x `height_m` metres with this grid.
std::string stroke_on(const std::string& width, const std::string& height, double width_m,
                      double height_m) {
  const auto touch = [&](const char* phase, double t, double across) {
    return R"({"t":)" + std::to_string(t) + R"(,"type":"touch","phase":")" + phase + R"(","x":)" +
           std::to_string(across * width_m) + R"(,"y":)" + std::to_string(0.5 * height_m) + "}\n";
  };
  return R"({"type":"header","format":"pentimento-log","version":1,"canvas":{"width":)" +
         std::to_string(width_m) + R"(,"height":)" + std::to_string(height_m) +
         R"(},"grid":{"width":)" + width + R"(,"height":)" + height + "}}\n" +
         touch("down", 0, 0.2) + touch("move", 0.1, 0.5) + touch("up", 0.2, 0.8);
}

TEST(ExtremeGrids, OfOneCellAndOfTheLongestSideArePainted) {
  Workplace place;
  for (const auto& [width, height, width_m, height_m] : {std::tuple{"1", "1", 0.01, 0.01},
                                                         {"1", "16384", 0.001, 16.384},
                                                         {"16384", "1", 16.384, 0.001},
                                                         {"3", "2", 100.0, 66.0}}) {
    place.write("a.jsonl", stroke_on(width, height, width_m, height_m));
    const Ran ran = place.run("render a.jsonl -o a.png -o a.h5 --quiet");
    EXPECT_EQ(ran.code, 0) << width << " x " << height << ": " << ran.err;
    EXPECT_EQ(place.run("info a.png").out.find(std::string("png, ") + width + " x " + height), 0U);
    EXPECT_EQ(place.run("relight a.h5 -o b.png --quiet").code, 0) << width << " x " << height;
    // There is paint on it, which there is none of at the beginning.
    place.run("render a.jsonl -o bare.png --at 0 --quiet");
    EXPECT_EQ(place.run("compare a.png b.png").code, 0) << width << " x " << height;
    EXPECT_EQ(place.run("compare a.png bare.png").code, 1) << width << " x " << height;
  }
}

TEST(ExtremeGrids, OfNoCellsAndOfMoreThanThereMayBeAreRefused) {
  Workplace place;
  for (const std::string side :
       {"0", "-1", "16385", "46341", "65536", "2147483648", "4294967297", "1e300"}) {
    place.write("a.jsonl", stroke_on(side, "8", 0.4, 0.3));
    const Ran ran = place.run("render a.jsonl -o a.png");
    EXPECT_EQ(ran.code, 3) << side;
    EXPECT_EQ(lines_in(ran.err), 1U) << ran.err;
    EXPECT_NE(ran.err.find("a.jsonl:1: grid.width"), std::string::npos) << ran.err;
  }
  EXPECT_FALSE(place.has("a.png"));
}

TEST(ExtremePictures, CountPixelsBeyond32Bits) {
  Workplace place;
  place.write("a.jsonl", stroke_on("64", "64", 0.1, 0.1));
  // The number of the last pixel has 33 bits at a side of 65536 and 40 at the longest side.
  for (const std::string side : {"32767", "32768", "46341", "65536", "1048576"}) {
    const std::string at = std::to_string(std::stol(side) - 20);
    const Ran ran = place.run("render a.jsonl -o a.png --quiet --detail 1 --width " + side +
                              " --crop " + at + "," + at + ",20,20");
    EXPECT_EQ(ran.code, 0) << side << ": " << ran.err;
  }
  EXPECT_EQ(place.run("render a.jsonl -o a.png --width 1048577").code, 2);
  const Ran foreseen = place.run("render a.jsonl -o b.png --dry-run --detail 1 --width 1048576");
  EXPECT_NE(foreseen.out.find("1048576 x 1048576 pixels"), std::string::npos) << foreseen.out;
  EXPECT_NE(foreseen.out.find("3298535 MB at most"), std::string::npos) << foreseen.out;
}

TEST(ExtremePictures, OfALargeCanvasWithLittlePaintFitInLittleMemory) {
  Workplace place;
  place.write("a.jsonl", stroke_on("16384", "16384", 160, 160));
  const Ran refused = place.run("render a.jsonl -o a.png --dry-run --detail 4");
  EXPECT_EQ(refused.code, 3) << "a canvas has 100 m at most: " << refused.err;
  place.write("a.jsonl", stroke_on("16384", "16384", 99, 99));
  // Planes for the whole of it would be 80 GB.
  const Ran ran = place.run("render a.jsonl -o a.png --dry-run --detail 4 --memory-limit 6G");
  EXPECT_EQ(ran.code, 0) << ran.err;
}

}  // namespace
}  // namespace pentimento::test
