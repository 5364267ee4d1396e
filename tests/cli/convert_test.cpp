#include <gtest/gtest.h>

#include "tests/cli/command_run.h"

namespace pentimento::test {
namespace {

const std::string kRecording =
    std::string(PENTIMENTO_TEST_DATA) + "/recordings/mypaint-painting30sec/painting30sec.dat";

TEST(CommandConvert, MakesALogOfARecordingAndReports) {
  const Workplace place;
  const Ran ran = place.run("convert " + kRecording + " -o m.jsonl.gz --json");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(json_member(ran.out, "strokes"), "30");
  EXPECT_EQ(json_member(ran.out, "samples"), "2253");
  EXPECT_EQ(place.run("validate m.jsonl.gz").code, 0);
  const Ran told = place.run("convert " + kRecording + " -o m.jsonl");
  EXPECT_EQ(told.out, "");
  EXPECT_NE(told.err.find("mypaint, 30 strokes, 2253 samples"), std::string::npos) << told.err;
  EXPECT_EQ(place.run("convert " + kRecording + " -o m.jsonl --quiet").err, "");
  EXPECT_EQ(place.run("convert " + kRecording + " -o m.jsonl --no-clobber").code, 5);
}

// Strokes and samples as the SOURCE.txt of each folder counts them.
TEST(CommandConvert, CountsWhatEachFileHolds) {
  struct Truth {
    const char* file;
    const char* strokes;
    const char* samples;
  };
  const Truth files[] = {{"a-painter/dancer.apa", "101", "6298"},
                         {"a-painter/mozfest.apa", "43", "2091"},
                         {"a-painter/rose_bush.apa", "229", "4837"},
                         {"a-painter/the_leap.apa", "206", "8808"},
                         {"excalidraw/despair.excalidrawlib", "137", "2142"},
                         {"excalidraw/panels.excalidraw", "8", "21"},
                         {"excalidraw/points-x-y-pressure-ms.json", "1", "360"},
                         {"handwriting/device-units.svc", "3", "501"},
                         {"handwriting/physical-units.svc", "5", "819"},
                         {"handwriting/pointer-events.json", "1", "148"},
                         {"mypaint-painting30sec/painting30sec.dat", "30", "2253"},
                         {"remarkable/all-pens-v5.rm", "185", "4309"},
                         {"remarkable/colour-and-tool-v6.rm", "25", "1370"},
                         {"remarkable/empty-v5.rm", "0", "0"},
                         {"remarkable/lines-with-text-v6.rm", "10", "469"},
                         {"remarkable/two-layers-line-v1-v6.rm", "2", "14"},
                         {"tables/digital-ink-processable.csv.gz", "177", "2787"},
                         {"tables/hello-world.csv.gz", "623", "15208"},
                         {"tilt-brush/Blue_Tit.tilt", "471", "9403"},
                         {"tilt-brush/Liz_Edwards_Portrait.tilt", "1952", "37773"},
                         {"tilt-brush/OilPaint.tilt", "67", "1231"},
                         {"tilt-brush/TiltMech.tilt", "869", "21393"},
                         {"wacom-uim/digital-ink-processable-3.0.json", "177", "2787"},
                         {"wacom-uim/digital-ink-processable-3.0.uim", "177", "2787"},
                         {"wacom-uim/digital-ink-processable.uim", "178", "2789"},
                         {"wacom-uim/hello-world.uim", "623", "15208"},
                         {"wacom-uim/raster-brushes.uim", "4", "124"}};
  const Workplace place;
  for (const Truth& truth : files) {
    const std::string file = std::string(PENTIMENTO_TEST_DATA) + "/recordings/" + truth.file;
    const Ran ran = place.run("convert " + file + " -o m.jsonl --json");
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(json_member(ran.out, "strokes"), truth.strokes) << truth.file;
    EXPECT_EQ(json_member(ran.out, "samples"), truth.samples) << truth.file;
    EXPECT_EQ(place.run("validate m.jsonl").code, 0) << truth.file;
  }
}

TEST(CommandConvert, IsAPartOfAPipe) {
  const Workplace place;
  const Ran ran =
      place.run("render - -o p.png --quiet --width 64",
                std::string(PENTIMENTO_COMMAND) + " convert - --quiet < " + kRecording + " |");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(place.has("p.png"));
}

TEST(CommandConvert, AnEditedLogIsTheSamePaintingFaster) {
  const Workplace place;
  ASSERT_EQ(place.run("convert a.jsonl -o b.jsonl --quiet").code, 0);
  const Ran a = place.run("render a.jsonl -o a.png --json --quiet");
  const Ran b = place.run("render b.jsonl -o b.png --json --quiet");
  EXPECT_EQ(json_member(a.out, "state_sha256"), json_member(b.out, "state_sha256"));
  EXPECT_EQ(place
                .run("convert a.jsonl -o c.jsonl --trim 0.2..0.9 --speed 2 --resample 30 "
                     "--fit 0.4x0.4 --size 1.5 --drop-idle 1 --quiet")
                .code,
            0);
  const Ran c = place.run("validate c.jsonl");
  EXPECT_EQ(c.code, 0) << c.err;
}

TEST(CommandConvert, RefusesOptionsThatMakeNoSense) {
  const Workplace place;
  for (const char* options :
       {"--trim 3", "--trim 5..2", "--trim a..b", "--fit 3", "--fit 0x1", "--speed 0",
        "--resample -1", "--as nonsense", "--view top", "--gravity-turn 45", "--json -o -"}) {
    const Ran ran = place.run("convert " + kRecording + " -o x.jsonl " + options);
    EXPECT_EQ(ran.code, 2) << options << ran.err;
    EXPECT_EQ(lines_in(ran.err), 1u) << options << ran.err;
    EXPECT_FALSE(place.has("x.jsonl")) << options;
  }
}

TEST(CommandList, TellsWhatLogsMayName) {
  const Workplace place;
  EXPECT_NE(place.run("list brushes").out.find("\nfilbert "), std::string::npos);
  EXPECT_NE(place.run("list formats --json").out.find("{\"name\":\"mypaint\""), std::string::npos);
  const Ran none = place.run("list pigments Cobolt");
  EXPECT_EQ(none.code, 2);
  EXPECT_EQ(lines_in(none.err), 1u);
}

}  // namespace
}  // namespace pentimento::test
