#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "formats/image/read_image.h"
#include "tests/cli/command_run.h"

namespace pentimento::test {
namespace {

TEST(CommandRender, WritesPicturesAndStateAndReports) {
  const Workplace place;
  const Ran ran = place.run("render a.jsonl -o a.png -o a.exr -o a.h5 --json");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(place.has("a.png") && place.has("a.exr") && place.has("a.h5"));
  EXPECT_EQ(place.files(), 4u);  // and the log: no temporaries
  EXPECT_EQ(lines_in(ran.out), 1u);
  EXPECT_EQ(json_member(ran.out, "steps"), "55");  // the mark at 1.2 s is in step 54
  for (const char* key :
       {"outputs", "simulated_s", "wall_s", "peak_memory_bytes", "threads", "state_sha256",
        "guide_sha256", "log_sha256", "paint", "medium", "deposited_m3", "picked_up_m3", "dried_m3",
        "wet_m3", "relative_difference", "pigments", "fluid", "phases"}) {
    EXPECT_NE(ran.out.find(std::string(1, '"').append(key).append("\":")), std::string::npos)
        << key;
  }
  EXPECT_EQ(json_member(ran.out, "state_sha256"), json_member(ran.out, "guide_sha256"));
}

TEST(CommandRender, TheStateIsTheSameForAnyNumberOfThreads) {
  const Workplace place;
  std::string state;
  for (const char* threads : {"1", "2", "7", "1", "2", "7"}) {
    const Ran ran =
        place.run(std::string("render a.jsonl -o a.h5 --json --quiet --threads ").append(threads));
    ASSERT_EQ(ran.code, 0) << ran.err;
    if (state.empty()) state = json_member(ran.out, "state_sha256");
    EXPECT_EQ(json_member(ran.out, "state_sha256"), state) << threads;
  }
  EXPECT_EQ(state.size(), 64u);
}

TEST(CommandRender, ItsPeakMemoryIsNotThatOfWhoStartedIt) {
  const Workplace place;
  const Ran ran = place.run("render a.jsonl -o a.png --json",
                            "python3 -c 'import os, sys; held = bytes([1]) * (900 << 20); "
                            "os.execv(sys.argv[1], sys.argv[1:])'");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_LT(std::stod(json_member(ran.out, "peak_memory_bytes")), 700 << 20);
}

TEST(CommandRender, ALogCanBePipedInAndAPictureOut) {
  const Workplace place;
  ASSERT_EQ(place.run("render a.jsonl -o a.png").code, 0);
  const Ran piped = place.run("render - -o -", "cat a.jsonl |");
  ASSERT_EQ(piped.code, 0) << piped.err;
  EXPECT_EQ(piped.out.substr(0, 4), "\x89PNG");
  place.run("render - -o b.png", "cat a.jsonl |");
  EXPECT_EQ(place.run("compare a.png b.png").code, 0);
}

TEST(CommandRender, StandardOutputCarriesOnlyWhatWasAskedFor) {
  const Workplace place;
  EXPECT_EQ(place.run("render a.jsonl -o a.png --progress ndjson").out, "");
  EXPECT_EQ(place.run("render a.jsonl -o a.png --quiet").err, "");
  const Ran both = place.run("render a.jsonl -o - --json");
  EXPECT_EQ(both.code, 2);
  EXPECT_EQ(both.out, "");
}

TEST(CommandRender, ProgressForProgramsIsAnObjectPerLine) {
  const Workplace place;
  const Ran ran = place.run("render a.jsonl -o a.png --progress ndjson --json");
  EXPECT_NE(ran.err.find("{\"phase\":\"simulate\""), std::string::npos);
  EXPECT_NE(ran.err.find("\"percent\":100"), std::string::npos);
}

/// Every line is one object: what does not begin and end so is words.
void expect_objects(const std::string& lines) {
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);)
    EXPECT_TRUE(line.starts_with("{\"") && line.ends_with("}")) << line;
}

TEST(CommandRender, ForProgramsWarningsErrorsAndTheReportAreObjectsToo) {
  Workplace place;
  place.write("b.jsonl", kSmallLog +
                             "{\"t\":2,\"type\":\"undo\"}\n{\"t\":2,\"type\":\"undo\"}\n"
                             "{\"t\":2,\"type\":\"undo\"}\n");
  const Ran done = place.run("render b.jsonl -o a.png --progress ndjson");
  ASSERT_EQ(done.code, 0) << done.err;
  expect_objects(done.err);
  EXPECT_NE(done.err.find("{\"warning\":\"1 undo"), std::string::npos) << done.err;
  EXPECT_NE(done.err.find("\n{\"report\":{\"outputs\""), std::string::npos) << done.err;
  const Ran failed = place.run("render missing.jsonl -o a.png --progress ndjson");
  EXPECT_EQ(failed.code, 5);
  expect_objects(failed.err);
  EXPECT_EQ(json_member(failed.err, "exit_code"), "5");
}

TEST(CommandRender, OnATerminalTheReportBeginsOnALineOfItsOwn) {
  const Workplace place;
  const Ran done = place.run("render a.jsonl -o a.png --progress tty");
  ASSERT_EQ(done.code, 0);
  const std::size_t cleared = done.err.rfind("\r\033[K");
  ASSERT_NE(cleared, std::string::npos);
  EXPECT_EQ(done.err.find('[', cleared + 4), std::string::npos) << "the bar is gone";
  EXPECT_NE(done.err.find("a.png", cleared), std::string::npos) << "the report follows";
}

TEST(CommandRender, WhatItCannotKeepItRefusesOrTells) {
  const Workplace place;
  const Ran gravity = place.run("render a.jsonl -o a.png --gravity=0,1e300,0");
  EXPECT_EQ(gravity.code, 2);
  EXPECT_EQ(gravity.err, "pentimento: --gravity 0,1e300,0: 1e+300 is outside -1000..1000 m/s^2\n");
  EXPECT_EQ(place.run("render a.jsonl -o a.exr --bit-depth 16").code, 2);
  EXPECT_EQ(place.run("render a.jsonl -o a.exr -o a.png --bit-depth 16").code, 0);
  const Ran scratch = place.run("render a.jsonl -o b.png --scratch missing");
  EXPECT_EQ(scratch.code, 5);
  EXPECT_EQ(scratch.err, "pentimento: --scratch missing: No such file or directory\n");
  const Ran large = place.run("render a.jsonl -o b.png --width 2640 --dry-run");
  EXPECT_NE(large.err.find("wants 33 fine cells per cell of the grid; 32 is the most"),
            std::string::npos)
      << large.err;
}

TEST(CommandRender, OutputsNameTheHashesOfTheFilesOfOptions) {
  const Workplace place;
  ASSERT_EQ(place.run("render a.jsonl -o s.h5 -o sky.exr").code, 0);
  ASSERT_EQ(place.run("render a.jsonl -o b.png --from s.h5 --environment sky.exr").code, 0);
  const std::string told = place.run("info b.png").out;
  for (const std::string name : {"s.h5", "sky.exr"})
    EXPECT_NE(told.find(run("sha256sum " + place.path(name)).second.substr(0, 64)),
              std::string::npos)
        << name << " in " << told;
}

TEST(CommandRender, AnExrWithoutDpiIsAsLargeAsTheCanvas) {
  const Workplace place;
  ASSERT_EQ(place.run("render a.jsonl -o a.exr --width 800").code, 0);
  // 800 pixels on 0.4 m are 50.8 an inch.
  const std::string header = run("exrheader " + place.path("a.exr")).second;
  EXPECT_NE(header.find("xDensity (type float): 50.8"), std::string::npos) << header;
  EXPECT_NE(header.find("detail (type int): 10"), std::string::npos) << header;
  EXPECT_NE(header.find("time_s (type double): "), std::string::npos) << header;
}

TEST(CommandRender, TheSizeIsGivenInOneWay) {
  const Workplace place;
  const Ran ran = place.run("render a.jsonl -o a.png --json --sim-scale 0.5 --width 160");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(json_member(ran.out, "width"), "160");
  EXPECT_EQ(json_member(ran.out, "height"), "120");
  EXPECT_NE(place.run("info a.png").out.find("80 x 60"), std::string::npos);  // the grid
  EXPECT_EQ(place.run("render a.jsonl -o b.png --width 10 --height 10").code, 2);
}

TEST(CommandRender, ALargerPictureIsTheSamePainting) {
  const Workplace place;
  const Ran small = place.run("render a.jsonl -o a.h5 -o a.png --json");
  const Ran large = place.run("render a.jsonl -o b.h5 -o b.png --scale 2.9 --json");
  ASSERT_EQ(large.code, 0) << large.err;
  EXPECT_EQ(json_member(large.out, "detail"), "3");
  EXPECT_EQ(json_member(large.out, "guide_sha256"), json_member(small.out, "state_sha256"));
  EXPECT_NE(json_member(large.out, "state_sha256"), json_member(small.out, "state_sha256"));
  EXPECT_NE(place.run("info b.h5").out.find("240 x 180"), std::string::npos);
  // The lock holds depth and amounts to a few roundings of float, per pigment over its layers.
  const Ran same = place.run("compare a.h5 b.h5 --json");
  EXPECT_EQ(json_member(same.out, "reduced"), "3");
  EXPECT_NE(same.out.find("\"relative_l2\""), std::string::npos);
  // From its dump the poster is shaded again, bit for bit.
  ASSERT_EQ(place.run("relight b.h5 -o c.png --scale 2.9").code, 0);
  EXPECT_EQ(place.run("compare b.png c.png").code, 0);
  EXPECT_EQ(place.run("render a.jsonl -o c.png --scale 2 --detail 40").code, 2);
}

/// Whether two pictures of the same size differ by no bit.
void expect_same(const Image& a, const Image& b) {
  ASSERT_EQ(a.width, b.width);
  ASSERT_EQ(a.height, b.height);
  for (std::size_t c = 0; c < 3; ++c)
    for (int y = 0; y < a.height; ++y)
      for (int x = 0; x < a.width; ++x)
        ASSERT_EQ(a.plane[c](x, y), b.plane[c](x, y)) << x << ", " << y;
}

TEST(CommandRender, APosterShowsTheLightOfTheTablet) {
  const Workplace place;
  const auto picture = [&](const std::string& command, const std::string& name) {
    const Ran ran = place.run(command + " -o " + name);
    EXPECT_EQ(ran.code, 0) << ran.err;
    auto image = read_image(place.path(name));
    EXPECT_TRUE(image);
    return image ? std::move(*image) : Image{};
  };
  const Image tablet = picture("render a.jsonl", "a.exr");
  const Image poster = picture("render a.jsonl --scale 4 -o b.h5", "b.exr");
  ASSERT_EQ(poster.width, 4 * tablet.width);
  double off = 0, light = 0, square = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    for (int y = 0; y < tablet.height; ++y) {
      for (int x = 0; x < tablet.width; ++x) {
        double sum = 0;
        for (int i = 0; i < 16; ++i)
          sum += static_cast<double>(poster.plane[c](4 * x + i % 4, 4 * y + i / 4));
        const double wanted = static_cast<double>(tablet.plane[c](x, y)), miss = sum / 16 - wanted;
        square += miss * miss;
        off += miss;
        light += wanted;
      }
    }
  }
  // 33.1 dB were measured, and 0.05 % more light; 28 dB and 0.7 % without the lock.
  EXPECT_GT(-10 * std::log10(square / (3 * tablet.width * tablet.height)), 32);
  EXPECT_NEAR(off / light, 0, 0.0015);
  // From its dump it is shaded again, and so is the tablet's picture.
  expect_same(picture("relight b.h5", "c.exr"), poster);
  expect_same(picture("relight b.h5 --scale 1", "c.exr"), tablet);
  // A crop is that part of it.
  const Image crop = picture("render a.jsonl --scale 4 --crop 133,70,61,90", "c.exr");
  ASSERT_EQ(crop.width, 61);
  ASSERT_EQ(crop.height, 90);
  for (std::size_t c = 0; c < 3; ++c)
    for (int y = 0; y < 90; ++y)
      for (int x = 0; x < 61; ++x)
        ASSERT_EQ(crop.plane[c](x, y), poster.plane[c](x + 133, y + 70)) << x << ", " << y;
}

TEST(CommandRender, AScratchFolderChangesNothing) {
  const Workplace place;
  const Ran whole = place.run("render a.jsonl --scale 8 -o a.png -o a.h5 --json");
  ASSERT_EQ(whole.code, 0) << whole.err;
  EXPECT_NE(whole.out.find("\"lock\":{\"blocks\":"), std::string::npos) << whole.out;
  const std::string picture = place.read("a.png"), state = place.read("a.h5");
  const Ran tight = place.run(
      "render a.jsonl --scale 8 --scratch . --memory-limit 180M --threads 7 -o a.png -o a.h5");
  ASSERT_EQ(tight.code, 0) << tight.err;
  EXPECT_TRUE(place.read("a.png") == picture);
  EXPECT_TRUE(place.read("a.h5") == state);
  EXPECT_EQ(place.files(), 3u);  // with the log: nothing is left of the scratch file
}

TEST(CommandRender, ThePublishedFluidHasNoFinerCanvas) {
  const Workplace place;
  const Ran larger = place.run("render a.jsonl -o a.png --scale 2 --scheme paper");
  EXPECT_EQ(larger.code, 2);
  EXPECT_NE(larger.err.find("--refine direct"), std::string::npos);
  EXPECT_EQ(place.run("render a.jsonl -o a.png --scheme paper").code, 0);
}

TEST(CommandRender, DirectIsMarkedAsAnotherPainting) {
  const Workplace place;
  const Ran direct = place.run("render a.jsonl -o a.png -o a.h5 --scale 2 --refine direct --json");
  ASSERT_EQ(direct.code, 0) << direct.err;
  EXPECT_NE(json_member(direct.out, "painting").find("160 x 120"), std::string::npos);
  EXPECT_NE(place.run("info a.png").out.find("another than the log's"), std::string::npos);
  EXPECT_NE(place.run("info a.h5").out.find("another than the log's"), std::string::npos);
  const Ran plain = place.run("render a.jsonl -o b.png --refine direct --json");
  EXPECT_EQ(plain.out.find("\"painting\""), std::string::npos);  // on the log's own grid
  EXPECT_EQ(place.run("render a.jsonl -o b.png --refine direct --detail 2").code, 2);
  EXPECT_EQ(place.run("render a.jsonl -o b.png --refine guided --sim-scale 2").code, 2);
}

TEST(CommandRender, APrintCarriesItsDpi) {
  const Workplace place;
  ASSERT_EQ(place.run("render a.jsonl -o a.png --print 4x3cm --dpi 100 --sim-scale 0.3").code, 0);
  const Ran info = place.run("info a.png --json");
  EXPECT_EQ(json_member(info.out, "width"), "157");  // 4 cm at 100 dpi
  // PNG stores whole dots per metre: 3937 are 99.9998 dots per inch.
  EXPECT_NEAR(std::stod(json_member(info.out, "dpi")), 100.0, 0.5 / 39.37);
}

TEST(CommandRender, ACropIsThatPartOfThePicture) {
  const Workplace place;
  ASSERT_EQ(place.run("render a.jsonl -o whole.png").code, 0);
  const Ran ran = place.run("render a.jsonl -o a.png --crop 10,20,30,15 --json");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(json_member(ran.out, "width"), "30");
  EXPECT_EQ(json_member(ran.out, "height"), "15");
  const auto whole = read_image(place.path("whole.png")), crop = read_image(place.path("a.png"));
  ASSERT_TRUE(whole && crop);
  ASSERT_EQ(crop->width, 30);
  ASSERT_EQ(crop->height, 15);
  for (std::size_t c = 0; c < 3; ++c)
    for (int y = 0; y < 15; ++y)
      for (int x = 0; x < 30; ++x)
        ASSERT_EQ(crop->plane[c](x, y), whole->plane[c](x + 10, y + 20)) << x << "," << y;
  EXPECT_EQ(place.run("render a.jsonl -o a.png --crop 70,0,20,10").code, 2);
}

TEST(CommandRender, ItStopsWhereItIsTold) {
  const Workplace place;
  const Ran ran = place.run("render a.jsonl -o f-%.h5 --at mark:half --at step:10 --at 0.2 --json");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(json_member(ran.out, "steps"), "23");
  EXPECT_TRUE(place.has("f-half.h5") && place.has("f-10.h5") && place.has("f-0.2.h5"));
  ASSERT_EQ(place.run("render a.jsonl -o g.h5 --at step:10").code, 0);
  EXPECT_EQ(place.run("compare f-0.2.h5 g.h5").code, 0);  // 0.2 s is in step 9
  EXPECT_EQ(place.run("render a.jsonl -o f.png --at mark:none").code, 2);
}

TEST(CommandRender, SettlingGoesOnWithNothingHappening) {
  const Workplace place;
  const Ran ran = place.run("render a.jsonl -o a.h5 --settle 1 --json");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(json_member(ran.out, "steps"), "100");
}

TEST(CommandRender, ADumpCanBeContinued) {
  const Workplace place;
  ASSERT_EQ(place.run("render a.jsonl -o a.h5").code, 0);
  const Ran ran = place.run("render a.jsonl --from a.h5 -o b.h5 --width 40 --json");
  ASSERT_EQ(ran.code, 0) << ran.err;
  const Ran info = place.run("info b.h5 --json");
  EXPECT_EQ(json_member(info.out, "width"), "80");  // the dump's grid, whatever the picture's size
  EXPECT_EQ(place.run("compare a.h5 b.h5").code, 1);
}

/// The first two lines of a log on 80 x 60 cells, and gravity.
std::string idle_log(const std::string& first, double end_s) {
  return kSmallLog.substr(0, kSmallLog.find('\n') + 1) + first +
         R"({"t":0,"type":"gravity","x":2,"y":3,"z":9})" + "\n" + R"({"t":)" +
         std::to_string(end_s) + R"(,"type":"mark","name":"over"})" + "\n";
}

TEST(CommandRender, ASessionCutInTwoEndsInTheStateOfTheWhole) {
  Workplace place;
  // Whole: 1.2 s as recorded (55 steps), then 180 steps in which paint flows and comes to rest.
  // Its picked colour #e0c020 joins the palette in both parts.
  place.write("whole.jsonl", kSmallLog + R"({"t":5.21,"type":"mark","name":"over"})" + "\n");
  const std::string colour = R"({"t":0,"type":"color","value":"#e0c020"})";
  place.write("idle.jsonl", idle_log(colour + "\n", 3.99));
  for (const std::string options : {"--scheme conservative", "--scheme paper", "--detail 3"}) {
    const std::string with = " --json " + options;
    const Ran whole = place.run("render whole.jsonl -o whole.h5" + with);
    ASSERT_EQ(place.run("render a.jsonl -o half.h5" + with).code, 0);
    const Ran rest = place.run("render idle.jsonl --from half.h5 -o rest.h5" + with);
    ASSERT_EQ(rest.code, 0) << rest.err;
    EXPECT_EQ(json_member(rest.out, "steps"), "180");
    EXPECT_EQ(json_member(rest.out, "state_sha256"), json_member(whole.out, "state_sha256"));
    EXPECT_EQ(place.run("compare whole.h5 rest.h5").code, 0);
  }
}

TEST(CommandRender, AFinerCanvasGoesOnOverTheSamePicture) {
  Workplace place;
  ASSERT_EQ(place.run("render a.jsonl -o p.png").code, 0);
  std::string half = kSmallLog;
  half.insert(half.find('\n') + 1, R"({"t":0,"type":"load","file":"p.png"})"
                                   "\n");
  place.write("half.jsonl", half);
  place.write("whole.jsonl", half + R"({"t":2.21,"type":"mark","name":"over"})" + "\n");
  place.write("idle.jsonl", idle_log(R"({"t":0,"type":"color","value":"#e0c020"})"
                                     "\n",
                                     0.99));
  const Ran whole = place.run("render whole.jsonl -o whole.h5 --detail 2 --json");
  ASSERT_EQ(place.run("render half.jsonl -o half.h5 --detail 2").code, 0);
  const Ran rest = place.run("render idle.jsonl --from half.h5 -o rest.h5 --detail 2 --json");
  EXPECT_EQ(json_member(rest.out, "state_sha256"), json_member(whole.out, "state_sha256"));
  EXPECT_NE(json_member(whole.out, "state_sha256"), "");
}

TEST(CommandRender, AFinerCanvasThatCannotGoOnIsMadeAnewAndSaysSo) {
  Workplace place;
  place.write("idle.jsonl", idle_log("", 0.5));
  ASSERT_EQ(place.run("render a.jsonl -o 1.h5").code, 0);
  ASSERT_EQ(place.run("render a.jsonl -o 2.h5 --detail 2").code, 0);
  const auto says = [&](const std::string& options) {
    const Ran ran = place.run("render idle.jsonl -o b.h5 --json " + options);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return ran.err;
  };
  EXPECT_EQ(says("--from 2.h5 --detail 2"), "");
  EXPECT_NE(says("--from 2.h5 --detail 3")
                .find("2.h5: its canvas is 2 times finer than its guide, "
                      "this one 3; the detail canvas is made anew"),
            std::string::npos);
  EXPECT_NE(
      says("--from 1.h5 --detail 2").find("it has no detail canvas; the detail canvas is made"),
      std::string::npos);
  EXPECT_NE(says("--from 2.h5").find("which alone goes on without --detail 2"), std::string::npos);
}

TEST(CommandRender, AModelParameterCanBeSet) {
  const Workplace place;
  const Ran a = place.run("render a.jsonl -o a.h5 --json");
  const Ran b = place.run("render a.jsonl -o b.h5 --set model.film_medium=1e-3 --json");
  ASSERT_EQ(b.code, 0) << b.err;
  EXPECT_NE(json_member(a.out, "state_sha256"), json_member(b.out, "state_sha256"));
  for (const char* bad : {"nu_max=1", "model.nu_maxx=1", "model.nu_max=x", "model.nu_max=-1"}) {
    EXPECT_EQ(place.run(std::string("render a.jsonl -o c.h5 --set ").append(bad)).code, 2) << bad;
  }
  EXPECT_FALSE(place.has("c.h5"));
}

TEST(CommandRender, AClearedPosterShowsNothingOfThePictureThatWasLoaded) {
  Workplace place;
  ASSERT_EQ(place.run("render a.jsonl -o photo.png").code, 0);
  const std::string header = kSmallLog.substr(0, kSmallLog.find('\n') + 1);
  const std::string load = R"({"t":0,"type":"load","file":"photo.png"})"
                           "\n";
  const std::string clear = R"({"t":0.1,"type":"clear"})"
                            "\n";
  const std::string end = R"({"t":0.2,"type":"mark","name":"end"})"
                          "\n";
  place.write("loaded.jsonl", header + load + end);
  place.write("cleared.jsonl", header + load + clear + end);
  place.write("bare.jsonl", header + end);
  for (const std::string log : {"loaded", "cleared", "bare"})
    ASSERT_EQ(place.run("render " + log + ".jsonl --detail 2 -o " + log + ".png").code, 0);
  EXPECT_EQ(place.run("compare cleared.png bare.png").code, 0);
  EXPECT_EQ(place.run("compare loaded.png bare.png").code, 1);
}

TEST(CommandRender, ItsProgressSaysHowFarAndOfHowMuch) {
  const Workplace place;
  const Ran ran = place.run("render a.jsonl -o a.png --progress ndjson");
  ASSERT_EQ(ran.code, 0) << ran.err;
  // Nothing moves before the first touch, in step 5.
  const std::size_t first = ran.err.find(R"({"phase":"simulate","done":4,)");
  ASSERT_NE(first, std::string::npos) << ran.err;
  EXPECT_EQ(json_member(ran.err.substr(first), "total"), "55");
  EXPECT_NEAR(std::stod(json_member(ran.err.substr(first), "percent")), 400.0 / 55, 1e-9);
}

TEST(CommandRender, DryRunTellsAndWritesNothing) {
  const Workplace place;
  const Ran ran = place.run("render a.jsonl -o a.png --width 800 --dry-run --json");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(json_member(ran.out, "grid_width"), "80");
  EXPECT_EQ(json_member(ran.out, "detail"), "10");
  EXPECT_EQ(json_member(ran.out, "steps"), "55");
  EXPECT_FALSE(place.has("a.png"));
  // Without outputs: 75 MB of programme, and of each of 80 x 60 cells 15 planes (depth, two
  // velocities, base, paper, stroke; three bands; two layers of blue, red and #e0c020) and what is
  // foreseen for the scheme, 24 more.
  const Ran none = place.run("render a.jsonl --dry-run --json");
  EXPECT_EQ(json_member(none.out, "memory_bytes"), std::to_string(75'000'000 + 4800 * 39 * 4));
  // A dump is built in memory, from a copy.
  const Ran dump = place.run("render a.jsonl -o a.h5 --dry-run --json");
  EXPECT_EQ(json_member(dump.out, "memory_bytes"),
            std::to_string(75'000'000 + 4800 * (39 + 2 * 15) * 4));
  EXPECT_EQ(json_member(dump.out, "disk_bytes"), std::to_string(4800 * 15 * 4));
}

#if !defined(PENTIMENTO_SANITIZED)  // whose memory adds to it
TEST(CommandRender, WhatADryRunForeseesIsNearWhatTheRenderTakes) {
  const Workplace place;
  const std::string options = "render a.jsonl -o a.h5 -o a.png --scale 8 --json";
  const Ran told = place.run(options + " --dry-run");
  const Ran done = place.run(options);
  ASSERT_EQ(done.code, 0) << done.err;
  const double foreseen = std::stod(json_member(told.out, "memory_bytes"));
  const double found = std::stod(json_member(done.out, "peak_memory_bytes"));
  // docs/bench/poster.md promises 1.2 either way; here it was 1.12. What Mesa takes of it is
  // another machine's, up to a half of so small a job.
  EXPECT_GT(foreseen, 0.7 * found);
  EXPECT_LT(foreseen, 1.4 * found);
}
#endif

TEST(CommandRender, ADryRunHasStandardOutputForItselfWhateverIsWritten) {
  const Workplace place;
  for (const char* json : {"", " --json"}) {
    const Ran ran = place.run(std::string("render a.jsonl -o - --dry-run").append(json));
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    EXPECT_EQ(ran.out.substr(0, 8), *json == 0 ? "picture " : "{\"width\"");
    EXPECT_EQ(place.files(), 1u);
  }
}

TEST(CommandRender, ADryRunCountsTheTiltThatIsRendered) {
  const Workplace place;
  const auto tilted = [&](const std::string& options) {
    const Ran ran = place.run("render a.jsonl --dry-run --json " + options);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return json_member(ran.out, "tilted_cell_steps");
  };
  const std::string log = tilted("");  // it tilts the canvas at 0.5 s
  EXPECT_GT(std::stod(log), 0);
  EXPECT_EQ(tilted("--gravity 0,0,9.81"), "0");
  EXPECT_GT(std::stod(tilted("--gravity 0,9.81,0")), std::stod(log));  // from the first stroke on
}

TEST(CommandRender, TheLocaleChangesNothing) {
  const Workplace place;
  // A German locale, with commas in its numbers, wherever the machine has what it is made from.
  test::run("mkdir -p " + place.path("locale") + " && localedef -i de_DE -f UTF-8 " +
            place.path("locale/de_DE.UTF-8"));
  const std::string options =
      "render a.jsonl -o a.h5 -o a.png -o a.exr --gravity 0.5,1.5,9 --exposure 0.5 --width 77 ";
  const auto files = [&](const std::string& before) {
    const Ran ran = place.run(options, before);
    EXPECT_EQ(ran.code, 0) << ran.err;
    std::vector<std::string> bytes;
    for (const char* file : {"a.h5", "a.png", "a.exr"}) bytes.push_back(place.read(file));
    bytes.push_back(place.run("info a.png --json", before).out);
    bytes.push_back(place.run("compare a.png a.exr --max 0.0125 --json", before).out);
    return bytes;
  };
  const std::vector<std::string> plain = files("LC_ALL=C");
  const std::vector<std::string> german =
      files("LOCPATH=" + place.path("locale") +
            " LC_ALL=de_DE.UTF-8 LC_NUMERIC=de_DE.UTF-8 TZ=Asia/Tokyo");
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_FALSE(plain[i].empty());
    EXPECT_TRUE(plain[i] == german[i]) << i;
  }
}

TEST(CommandRender, APictureOfAStarPaintsAStar) {
  // A star, white on black, stamped over the middle of a canvas of 0.4 m by 0.3 m.
  Workplace place;
  constexpr int kSide = 61;
  std::string star = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 61 +X 61\n";
  const auto in_star = [](double x, double y) {  // x right, y down, from -1 to 1
    const double angle = std::atan2(x, -y), fifth = 2 * 3.14159265358979 / 5;
    const double off = std::abs(angle - fifth * std::round(angle / fifth));  // from the next tip
    const double inner = 0.4, tip_x = 1, dent_x = inner * std::cos(fifth / 2);
    const double dent_y = inner * std::sin(fifth / 2), r = std::hypot(x, y);
    // On the centre's side of the line from the tip (1, 0) to the dent between two tips.
    return (r * std::cos(off) - tip_x) * dent_y - r * std::sin(off) * (dent_x - tip_x) < 0;
  };
  const auto of = [](int i) { return 2 * (i + 0.5) / kSide - 1; };
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i)
      star += in_star(of(i), of(j)) ? "\x80\x80\x80\x81" : std::string(4, '\0');
  place.write("star.hdr", star);
  place.write(
      "star.jsonl",
      R"({"type":"header","format":"pentimento-log","version":1,"canvas":{"width":0.4,"height":0.3},)"
      R"("grid":{"width":160,"height":120},"palette":[{"name":"blue","color":"#101840"}],)"
      R"("brushes":[{"name":"star","texture":"star.hdr"}]})"
      "\n"
      R"({"t":0,"type":"color","pigment":"blue"})"
      "\n"
      R"({"t":0,"type":"brush","name":"star"})"
      "\n"
      R"({"t":0,"type":"slider","name":"size","value":0.2})"
      "\n"
      R"({"t":0,"type":"touch","phase":"down","x":0.2,"y":0.15,"pressure":1})"
      "\n"
      R"({"t":0.1,"type":"touch","phase":"up","x":0.2,"y":0.15,"pressure":1})"
      "\n");
  const Ran ran = place.run("render star.jsonl -o star.png");
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto picture = read_rgb(place.path("star.png"));
  ASSERT_TRUE(picture);
  int wrong = 0, inside = 0;
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 160; ++x) {
      const bool star_here = in_star((x + 0.5 - 80) / 40, (y + 0.5 - 60) / 40);
      const bool dark = (*picture)[0](x, y) < 0.25f;
      inside += star_here ? 1 : 0;
      wrong += star_here != dark ? 1 : 0;
    }
  EXPECT_GT(inside, 1000);
  EXPECT_LT(wrong, 250);  // along 400 cells of outline
}

TEST(CommandRender, ItsPictureNamesTheCommandThatMakesItAgain) {
  const Workplace place;
  ASSERT_EQ(place.run("render a.jsonl --json -o 'a b.png' --exposure=0.5 -o c.exr").code, 0);
  const Ran info = place.run("info 'a b.png' --json");
  EXPECT_EQ(json_member(info.out, "command"),
            "pentimento render a.jsonl --exposure=0.5 -o 'a b.png'");
  ASSERT_EQ(place.run("render a.jsonl --exposure=0.5 -o again.png").code, 0);
  EXPECT_EQ(place.run("compare 'a b.png' again.png").code, 0);
}

}  // namespace
}  // namespace pentimento::test
