#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "formats/image/read_image.h"
#include "formats/io/provenance.h"
#include "formats/video/video_reader.h"
#include "formats/video/video_writer.h"
#include "tests/cli/command_run.h"

namespace pentimento::test {
namespace {

TEST(CommandHelp, StandsOnStandardOutputWithExamplesFirst) {
  const Workplace place;
  for (const char* command :
       {"", "render ", "relight ", "info ", "validate ", "convert ", "list ", "compare "}) {
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

TEST(CommandDescribe, TellsTheTableOfOptionsAsJson) {
  const Workplace place;
  using Json = nlohmann::json;
  const Json commands = Json::parse(place.run("--describe").out);
  ASSERT_FALSE(commands.empty());
  EXPECT_EQ(commands[0]["name"], "render");
  for (const Json& command : commands) {
    const std::string name = command["name"];
    const Ran ran = place.run(name + " --describe");
    EXPECT_EQ(ran.code, 0) << name;
    EXPECT_EQ(Json::parse(ran.out)["name"], "pentimento " + name);
  }
  const Json list = Json::parse(place.run("list --describe").out)["options"];
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(list[0]["names"], Json({"-h", "--help"}));
  EXPECT_EQ(list[1]["names"], Json::array());
  EXPECT_EQ(list[1]["choices"], Json({"brushes", "pigments", "parameters", "formats", "limits"}));
  EXPECT_TRUE(list[1]["required"]);
  EXPECT_FALSE(list[2]["required"]);
  EXPECT_EQ(list[3]["value"], "");
}

TEST(CommandDescribe, TellsWhatMayBeGivenManyTimes) {
  const Workplace place;
  const nlohmann::json table = nlohmann::json::parse(place.run("render --describe").out);
  std::set<std::string> repeatable;
  for (const auto& option : table["options"]) {
    if (option["repeatable"]) repeatable.insert(option["names"].back());
  }
  EXPECT_EQ(repeatable, (std::set<std::string>{"--at", "--lamp", "--limit", "--output", "--set"}));
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

/// kSmallLog in spectral optics.
std::string spectral_log() {
  std::string log = kSmallLog;
  return log.replace(log.find("\"palette\""), 0, "\"optics\":\"spectral\",");
}

TEST(CommandRelight, OtherPaintsChangeWhatIsWetAndTheSameOnesNothing) {
  Workplace place;
  place.write("s.jsonl", spectral_log());
  for (const std::string name : {"a", "s"}) {
    ASSERT_EQ(place.run("render " + name + ".jsonl -o a.png -o a.h5").code, 0);
    ASSERT_EQ(place.run("relight a.h5 -o b.png").code, 0);
    EXPECT_EQ(place.run("compare a.png b.png").code, 0);
    // A log is a palette's file: its own paints leave the picture as it is.
    ASSERT_EQ(place.run("relight a.h5 -o c.png --palette " + name + ".jsonl").code, 0);
    EXPECT_EQ(place.run("compare a.png c.png").code, 0);
    ASSERT_EQ(place
                  .run("relight a.h5 -o d.png --palette 'blue=golden phthalo blue red "
                       "shade,red=#20a040'")
                  .code,
              0);
    EXPECT_EQ(place.run("compare a.png d.png").code, 1);
  }
}

TEST(CommandRelight, PaintsThatCannotBeExchangedAreErrors) {
  Workplace place;
  ASSERT_EQ(place.run("render a.jsonl -o a.h5").code, 0);
  const auto fails = [&](const std::string& palette, int code, const std::string& says) {
    const Ran ran = place.run("relight a.h5 -o b.png --palette " + palette);
    EXPECT_EQ(ran.code, code) << palette;
    EXPECT_NE(ran.err.find(says), std::string::npos) << ran.err;
    EXPECT_FALSE(place.has("b.png"));
  };
  fails("green=#00ff00", 2, "no pigment \"green\", but blue, red, #e0c020");
  fails("'blue=Cobalt Blu'", 2, "did you mean \"Cobalt Blue\"?");
  fails("blue=#12", 2, "no colour");
  fails("blue=#102030,red", 2, "is not NAME=PAINT");
  fails("nowhere.json", 5, "nowhere.json");
  place.write("empty.json", "{}");
  fails("empty.json", 3, "has no palette");
  place.write("pretty.json", "{\n \"palette\": [\n  {\"name\": \"blue\", \"opacity\": 2}]}");
  fails("pretty.json", 3, "opacity");
  std::string many = kSmallLog;
  for (int i = 10; i < 20; ++i) {
    many += "{\"t\":2,\"type\":\"color\",\"value\":\"#0000" + std::to_string(i) + "\"}\n";
  }
  place.write("a.jsonl", many);
  ASSERT_EQ(place.run("render a.jsonl -o a.h5").code, 0);
  fails("blue=#102030", 3, "optical channels");
}

TEST(CommandRelight, ALightOfAnotherColourFallsOnSpectralPaintOnly) {
  Workplace place;
  place.write("s.jsonl", spectral_log());
  ASSERT_EQ(place.run("render s.jsonl -o s.png -o s.h5 -o a.h5").code, 0);
  ASSERT_EQ(place.run("relight s.h5 -o t.png --illuminant F11 --observer 1964").code, 0);
  EXPECT_EQ(place.run("compare s.png t.png").code, 1);
  EXPECT_EQ(place.run("relight s.h5 -o t.png --illuminant moon").code, 2);
  ASSERT_EQ(place.run("render a.jsonl -o a.h5").code, 0);
  EXPECT_EQ(place.run("relight a.h5 -o t.png --illuminant A").code, 2);
  // A canvas in other bands cannot be gone on with.
  const Ran ran = place.run("render a.jsonl --from s.h5 -o t.png");
  EXPECT_EQ(ran.code, 3);
  EXPECT_NE(ran.err.find("its optics are bands at"), std::string::npos) << ran.err;
}

TEST(CommandRelight, WithEverythingTheLightCanDoItIsTheRender) {
  const Workplace place;
  const std::string light =
      " --width 100 --varnish 0.4 --occlusion 0.8 --exposure -0.3 --white-point 4200 "
      "--tone-curve soft --lamp dir:-1,1,1,0.6 --lamp pos:0.1,0.1,0.2,0.3,1,0.5,0.2 "
      "--lamp dir:1,0,0.4,0.2";
  ASSERT_EQ(place.run("render a.jsonl -o a.png -o a.exr -o a.h5 --float" + light).code, 0);
  ASSERT_EQ(place.run("relight a.h5 -o b.png -o b.exr --float --width 100 --tile 31").code, 0);
  EXPECT_EQ(place.run("compare a.png b.png").code, 0);
  EXPECT_EQ(place.run("compare a.exr b.exr").code, 0);
  ASSERT_EQ(place.run("relight a.h5 -o c.png -o c.exr --float --width 100 --tone-curve none").code,
            0);
  EXPECT_EQ(place.run("compare a.exr c.exr").code, 0);  // EXR stays linear
  EXPECT_EQ(place.run("compare a.png c.png").code, 1);
}

TEST(CommandRelight, ALightPathIsAFrameAPoint) {
  const Workplace place;
  ASSERT_EQ(place.run("render a.jsonl -o a.png -o a.h5").code, 0);
  const Ran ran = place.run("relight a.h5 -o f-%02d.png --light-path orbit --frames 3");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(place.run("compare a.png f-00.png").code, 0);
  EXPECT_EQ(place.run("compare f-01.png f-02.png").code, 1);
  EXPECT_EQ(place.run("relight a.h5 -o f.png --light-path orbit --frames 3").code, 2);
  EXPECT_EQ(place.run("relight a.h5 -o f-%d.png --light-path orbit").code, 2);
  EXPECT_EQ(place.run("relight a.h5 -o f.png --frames 3").code, 2);
}

TEST(CommandRelight, ALightPathIsAlsoAFilm) {
  Workplace place;
  ASSERT_EQ(place.run("render a.jsonl -o a.h5").code, 0);
  const Ran ran = place.run(
      "relight a.h5 -o turn.avi -o f-%d.png --light-path orbit --frames 3 --fps 2 --json");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(place.files(), 6u);  // log, dump, film, three frames
  auto video = VideoReader::open(place.path("turn.avi"));
  ASSERT_TRUE(video.ok()) << video.error().message;
  for (int i = 0; i < 3; ++i) {
    const auto frame = (*video)->frame_at(0.5 * i);
    const auto still = read_rgb(place.path("f-" + std::to_string(i) + ".png"));
    ASSERT_TRUE(frame.ok() && still.ok());
    double difference = 0;
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 80; ++x)
        difference += std::abs(static_cast<double>((*frame)[1](x, y) - (*still)[1](x, y)));
    EXPECT_LT(difference / (60 * 80), 0.03);  // JPEG on the threads of the weave
  }
  place.write("old.mp4", "old");
  for (const char* wrong : {"relight a.h5 -o old.mp4",
                            "relight a.h5 -o old.mp4 --light-path orbit --frames 2 --width 81",
                            "relight a.h5 -o a.png --fps 2"}) {
    const Ran refused = place.run(wrong);
    EXPECT_EQ(refused.code, 2) << wrong;
    EXPECT_EQ(lines_in(refused.err), 1u) << refused.err;
  }
  EXPECT_EQ(place.read("old.mp4"), "old");
  EXPECT_EQ(place.files(), 7u);
}

TEST(CommandRelight, InTheSameLightAndBeforeTheSameCameraItIsTheRender) {
  Workplace place;
  ASSERT_EQ(place.run("render a.jsonl -o plain.png -o front.png --varnish 1").code, 0);
  place.write("c.jsonl", kSmallLog + R"({"t":1.2,"type":"camera","file":"front.png","fov":90})"
                                     "\n");
  ASSERT_EQ(place.run("render c.jsonl -o a.png -o a.h5 --varnish 1").code, 0);
  ASSERT_EQ(place.run("relight a.h5 -o b.png --tile 40").code, 0);
  EXPECT_EQ(place.run("compare a.png b.png").code, 0);
  EXPECT_EQ(place.run("compare a.png plain.png").code, 1);
}

TEST(CommandRelight, InTheSameLightOfAProbeItIsTheRender) {
  Workplace place;
  ASSERT_EQ(place.run("render a.jsonl -o plain.png -o probe.exr --varnish 1 --width 80").code, 0);
  const auto lit = [&](const std::string& name, const std::string& more) {
    place.write(name + ".jsonl",
                kSmallLog + R"({"t":1.2,"type":"environment","file":"probe.exr")" + more + "}\n");
    const std::string to = " -o " + name + ".png -o " + name + ".h5 --varnish 1";
    ASSERT_EQ(place.run("render " + name + ".jsonl" + to).code, 0);
    ASSERT_EQ(place.run("relight " + name + ".h5 -o again.png --tile 40 --threads 1").code, 0);
    EXPECT_EQ(place.run("compare " + name + ".png again.png").code, 0);
  };
  lit("sharp", "");
  lit("soft", R"(,"soft":true)");
  EXPECT_EQ(place.run("compare sharp.png soft.png").code, 1);
  EXPECT_EQ(place.run("compare sharp.h5 soft.h5").code, 0);  // the same paint
  ASSERT_EQ(place.run("relight sharp.h5 -o again.png --soft-environment").code, 0);
  EXPECT_EQ(place.run("compare soft.png again.png").code, 0);
  ASSERT_EQ(place.run("relight soft.h5 -o again.png --environment probe.exr").code, 0);
  EXPECT_EQ(place.run("compare sharp.png again.png").code, 0);
}

TEST(CommandRelight, WhatAVideoShowsIsReflectedAtItsTime) {
  Workplace place;
  // Half a second dark, half a second bright; the event happens at 0.2 s of the log.
  VideoOptions film;
  film.width = 32;
  film.height = 18;
  film.frames_per_second = 2;
  auto video = create_video(place.path("front.avi"), film);
  ASSERT_TRUE(video.ok());
  for (const float light : {0.0f, 1.0f}) {
    const Field<float> plane(32, 18, light);
    ASSERT_TRUE(
        (*video)->write({0, 18, {"R", "G", "B"}, {plane.view(), plane.view(), plane.view()}}).ok());
  }
  ASSERT_TRUE((*video)->finish().ok());
  const auto with_camera = [](const std::string& more) {
    std::string log = kSmallLog;
    const std::string event = R"({"t":0.2,"type":"camera","file":"front.avi")" + more + "}\n";
    return log.insert(log.find(R"({"t":0.3,)"), event);
  };
  place.write("v.jsonl", with_camera(""));
  place.write("later.jsonl", with_camera(R"(,"start":0.5)"));
  const std::string at = " --light 0,0,1 --at 0.4 --at 0.8 ";
  ASSERT_EQ(place.run("render v.jsonl -o v-%.png -o v-%.h5" + at).code, 0);
  ASSERT_EQ(place.run("render later.jsonl -o l-%.png" + at).code, 0);
  ASSERT_EQ(place.run("relight v-0.8.h5 -o r.png").code, 0);
  EXPECT_EQ(place.run("compare v-0.8.png r.png").code, 0);      // the dump has the frame
  EXPECT_EQ(place.run("compare v-0.4.png l-0.4.png").code, 1);  // dark; already bright
  EXPECT_EQ(place.run("compare v-0.8.png l-0.8.png").code, 0);  // both bright
  place.write("front.avi", place.read("front.avi").substr(0, 300));
  const Ran broken = place.run("validate v.jsonl");
  EXPECT_EQ(broken.code, 3);
  EXPECT_NE(broken.err.find("v.jsonl:4: "), std::string::npos) << broken.err;
}

TEST(CommandRender, LayersAndFloatsNeedAFileThatHoldsThem) {
  const Workplace place;
  for (const char* wrong : {"-o a.h5 --aov height", "-o - --aov height", "-o a.png --float"}) {
    const Ran ran = place.run(std::string("render a.jsonl ").append(wrong));
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(lines_in(ran.err), 1u) << ran.err;
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(place.files(), 1u);
  }
}

TEST(CommandRender, LayersBesideAPngAreThoseOfTheExr) {
  const Workplace place;
  ASSERT_EQ(place.run("render a.jsonl -o a.h5").code, 0);
  const std::string aovs = " --width 100 --aov height,normal,pigment ";
  const Ran ran = place.run("relight a.h5 -o a.png --json" + aovs);
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(place.files(), 2u + 1 + 2 + 3);  // log and dump; picture; height, normal; paints
  ASSERT_EQ(place.run("relight a.h5 -o a.exr -o b.png --float" + aovs).code, 0);
  EXPECT_FALSE(place.has("b.height.png"));  // an EXR has room for them
  const auto exr = read_image(place.path("a.exr"));
  ASSERT_TRUE(exr.ok());
  for (const auto& [file, layer] : {std::pair{"a.height.png", "height.Y"},
                                    {"a.normal.png", "normal.X"},
                                    {"a.pigment.blue.png", "pigment.blue"}}) {
    const auto png = read_image(place.path(file), {SampleMeaning::kRaw, {}});
    const auto about = describe_file(place.path(file));
    ASSERT_TRUE(png.ok() && about.ok()) << file;
    const double offset = std::stod(provenance_value(about->provenance, "aov.offset"));
    const double per_code = std::stod(provenance_value(about->provenance, "aov.per_code"));
    const Field<float>& truth = *exr->find(layer);
    for (int y = 0; y < png->height; y += 3) {
      for (int x = 0; x < png->width; x += 5) {
        const double value = offset + per_code * 65535 * static_cast<double>(png->plane[0](x, y));
        // Half a code, and the rounding of single precision.
        EXPECT_NEAR(value, static_cast<double>(truth(x, y)), 0.51 * per_code) << layer;
      }
    }
  }
  EXPECT_NE(ran.out.find("\"per_code\":"), std::string::npos);
  EXPECT_EQ(place.run("relight a.h5 -o a.png -o a.height.png --aov height").code, 2);
}

TEST(CommandDebugView, IsAPictureWithItsLegendFromLogAndDump) {
  const Workplace place;
  ASSERT_EQ(place.run("render a.jsonl -o a.h5").code, 0);
  for (const char* view : {"velocity", "layers"}) {
    const std::string option = std::string(" --scale 4 --debug-view ") + view;
    ASSERT_EQ(place.run("relight a.h5 -o a.png" + option).code, 0);
    const Ran info = place.run("info a.png --json");
    EXPECT_EQ(json_member(info.out, "height"), "300") << info.out;  // 240 and the legend
    EXPECT_NE(info.out.find(std::string("\"debug_view\":\"") + view), std::string::npos)
        << info.out;
  }
  ASSERT_EQ(place.run("render a.jsonl -o b.png --debug-view wetness").code, 0);
  ASSERT_EQ(place.run("relight a.h5 -o c.png --debug-view wetness").code, 0);
  EXPECT_EQ(place.run("compare b.png c.png").code, 0);
}

TEST(CommandDebugView, IsRefusedWhereItMeansNothing) {
  const Workplace place;
  const auto fails = [&](const std::string& options, const std::string& says) {
    const Ran ran = place.run("render a.jsonl " + options);
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(lines_in(ran.err), 1u) << ran.err;
    EXPECT_NE(ran.err.find(says), std::string::npos) << ran.err;
    EXPECT_EQ(place.files(), 1u);
  };
  fails("-o a.png --debug-view heigth", "height, velocity, pigment, layers, wetness");
  fails("-o a.exr --debug-view height", "FILE.png");
  fails("-o a.png --debug-view height --float", "--float");
}

TEST(CommandRender, ALampIsRefusedWhereItSaysNothing) {
  const Workplace place;
  for (const char* lamp : {"1,1,1", "dir:1,1", "dir:0,0,0", "pos:1,1,1,-2", "dir:1,1,1,1,1"})
    EXPECT_EQ(place.run(std::string("render a.jsonl -o a.png --lamp ").append(lamp)).code, 2);
  EXPECT_EQ(place.run("render a.jsonl -o a.png --tone-curve hard").code, 2);
  EXPECT_EQ(place.run("render a.jsonl -o a.png --white-point 300").code, 2);
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
  // Each threshold judges its own figure: what lies between the two passes as one and not as the
  // other.
  const std::string planes = json.out.substr(json.out.find("planes"));
  const double rms = std::stod(json_member(planes, "rms"));
  const double max = std::stod(json_member(planes, "max"));
  ASSERT_LT(rms, max);
  const std::string between = std::to_string((rms + max) / 2);
  EXPECT_EQ(place.run("compare a.png b.png --rms " + between).code, 0);
  EXPECT_EQ(place.run("compare a.png b.png --max " + between).code, 1);
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

TEST(CommandInfo, ShowsNamesThatATerminalDoesNotObey) {
  Workplace place;
  std::string log = kSmallLog;
  log.replace(log.find(R"("palette")"), 0, R"("title":"\u001b[31m",)");
  place.write("b.jsonl",
              log + R"({"t":3,"type":"mark","name":"\u001b]0;mine\u0007\u009b2J"})" + "\n");
  const Ran info = place.run("info b.jsonl");
  ASSERT_EQ(info.code, 0) << info.err;
  EXPECT_EQ(info.out.find('\x1b'), std::string::npos) << info.out;
  EXPECT_EQ(info.out.find('\a'), std::string::npos) << info.out;
  EXPECT_EQ(info.out.find("\u009b"), std::string::npos) << info.out;
  EXPECT_NE(info.out.find("]0;mine"), std::string::npos) << info.out;
}

TEST(CommandValidate, GivesAVerdictPerLog) {
  Workplace place;
  place.write("b.jsonl", "{}\n");
  EXPECT_EQ(place.run("validate a.jsonl").code, 0);
  const Ran both = place.run("validate a.jsonl b.jsonl --json");
  EXPECT_EQ(both.code, 3);
  // Several faults: the worst one counts, wherever it stands.
  EXPECT_EQ(place.run("validate nowhere.jsonl").code, 5);
  EXPECT_EQ(place.run("validate nowhere.jsonl b.jsonl a.jsonl").code, 5);
  EXPECT_EQ(both.err, "");
  EXPECT_NE(both.out.find("\"valid\":true"), std::string::npos);
  EXPECT_NE(both.out.find("\"valid\":false"), std::string::npos);
}

}  // namespace
}  // namespace pentimento::test
