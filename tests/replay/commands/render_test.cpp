#include "replay/commands/render.h"

#include <gtest/gtest.h>

#include "formats/hdf5/state_dump.h"
#include "formats/video/video_writer.h"
#include "tests/replay/small_job.h"

namespace pentimento {
namespace {

using test::JobFolder;
using test::rendered;
using test::small_header;

/// As another programme counts it.
std::string sha256sum(const std::string& path) {
  return test::run("sha256sum " + path).second.substr(0, 64);
}

TEST(Render, ReportAndFilesNameTheLogTheStateAndTheGuideBelowAFinerCanvas) {
  const JobFolder folder;
  const JobReport plain = rendered(folder.job({"plain.h5"}));
  EXPECT_EQ(plain.guide_sha256, plain.state_sha256);
  RenderJob finer = folder.job({"a.h5", "a.png", "a.exr"});
  finer.detail = 2;
  const JobReport report = rendered(finer);
  const auto dump = read_state(folder.path("a.h5"));
  ASSERT_TRUE(dump) << dump.error().message;
  EXPECT_EQ(report.guide_sha256, plain.state_sha256);
  EXPECT_EQ(report.state_sha256, detail_sha256(*dump->fine));  // counted from what was written
  EXPECT_NE(report.state_sha256, report.guide_sha256);
  EXPECT_EQ(report.log_sha256, sha256sum(folder.path("a.jsonl")));
  EXPECT_EQ(report.detail, 2);
  EXPECT_EQ(dump->log_sha256, report.log_sha256);
  EXPECT_EQ(dump->guide_sha256, plain.state_sha256);
  for (const char* file : {"a.h5", "a.png", "a.exr"}) {
    EXPECT_EQ(folder.says(file, "log_sha256"), report.log_sha256) << file;
    EXPECT_EQ(folder.says(file, "state_sha256"), report.state_sha256) << file;
    EXPECT_EQ(folder.says(file, "guide_sha256"), plain.state_sha256) << file;
    EXPECT_EQ(folder.says(file, "detail"), "2") << file;
    EXPECT_EQ(folder.says(file, "grid"), "80 x 60") << file;
  }
  ASSERT_EQ(report.outputs.size(), 3u);
  for (const WrittenFile& output : report.outputs)
    EXPECT_EQ(output.sha256, sha256sum(output.file)) << output.file;
}

TEST(Render, OfALargeCanvasOnlyWhatIsPaintedMustFit) {
  const std::string header =
      R"({"type":"header","format":"pentimento-log","version":1,"canvas":{"width":0.5,"height":0.4},)"
      R"("grid":{"width":2560,"height":2048},"palette":[{"name":"blue","color":"#1f2f8c"}]})"
      "\n";
  const std::string tilt = R"({"t":0,"type":"gravity","x":0,"y":9.81,"z":0})"
                           "\n";
  const std::string dab = R"({"t":0,"type":"slider","name":"size","value":0.004})"
                          "\n"
                          R"({"t":0,"type":"touch","phase":"down","x":0.1,"y":0.1})"
                          "\n"
                          R"({"t":0.05,"type":"touch","phase":"up","x":0.103,"y":0.1})"
                          "\n";
  const JobFolder folder(header + dab);
  RenderJob job = folder.job({"a.png"});
  job.size.width = 64;
  job.max_memory = 500'000'000;  // painted all over it takes 900 MB
  const JobReport report = rendered(job);
  EXPECT_EQ(report.outputs.size(), 1u);
  // Paint that may run is counted everywhere.
  folder.write("a.jsonl", header + tilt + dab);
  const auto refused = render(job, Control());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kLimit);
}

TEST(Render, AnIdleLogComputesAStepAfterEachEventOnly) {
  const JobFolder folder(small_header() + R"({"t":20,"type":"mark","name":"a"})"
                                          "\n"
                                          R"({"t":60,"type":"mark","name":"b"})"
                                          "\n");
  RenderJob job = folder.job({"a.h5"});
  // Up to each event one step is computed, which finds that nothing moves; so is the last one.
  for (const auto& [scheme, computed] : {std::pair{"paper", 3}, {"conservative", 3}}) {
    job.model = {{"scheme", scheme}};
    const JobReport report = rendered(job);
    EXPECT_EQ(report.steps, 60 * 45 + 1);  // to the end of the step of the last event
    EXPECT_DOUBLE_EQ(report.simulated_s, (60 * 45 + 1) / 45.0);
    EXPECT_EQ(report.steps_computed, computed) << scheme;
  }
}

TEST(Render, StopsAreVisitedInTheirOrderWhateverThatOfTheOptions) {
  const JobFolder folder;
  rendered(folder.job({"f-%.h5"}, {"mark:half", "step:10", "1"}));
  // The mark at 0.5 s is in step 22, 1 s in step 45: each stop is the end of its step.
  for (const auto& [file, step, time_s] : {std::tuple{"f-half.h5", 23, "0.5111111111111111"},
                                           {"f-10.h5", 10, "0.2222222222222222"},
                                           {"f-1.h5", 46, "1.0222222222222221"}}) {
    const auto dump = read_state(folder.path(file));
    ASSERT_TRUE(dump) << dump.error().message;
    EXPECT_EQ(dump->state.step, step);
    EXPECT_EQ(folder.says(file, "step"), std::to_string(step));
    EXPECT_EQ(folder.says(file, "time_s"), time_s);
    EXPECT_EQ(folder.says(file, "steps_per_second"), "45");
  }
}

TEST(Render, ACanvasThatGoesOnCountsItsStepsAndStrokesOn) {
  const JobFolder folder;
  rendered(folder.job({"half.h5"}));
  folder.write("more.jsonl", test::kSmallLog);
  RenderJob job = folder.job({"more.h5"}, {}, "more.jsonl");
  job.from = folder.path("half.h5");
  const JobReport report = rendered(job);
  EXPECT_EQ(report.steps, 55);  // of this log
  EXPECT_EQ(folder.says("more.h5", "step"), "110");
  EXPECT_EQ(folder.says("more.h5", "time_s"), "2.4444444444444446");  // 110 / 45
  const auto dump = read_state(folder.path("more.h5"));
  ASSERT_TRUE(dump) << dump.error().message;
  std::uint32_t last = 0;
  for (int y = 0; y < 60; ++y)
    for (const std::uint32_t id : dump->state.stroke.view().row_span(y)) last = std::max(last, id);
  EXPECT_EQ(last, 4u);  // two strokes in either log
}

/// kSmallLog without its events of gravity.
std::string level_log() {
  std::string log = test::kSmallLog;
  const std::size_t at = log.find(R"({"t":0.5,"type":"gravity")");
  return log.erase(at, log.find('\n', at) + 1 - at);
}

TEST(Render, GravityOfTheJobStandsInPlaceOfTheLogs) {
  std::string tilted = level_log();
  tilted.insert(small_header().size(), R"({"t":0,"type":"gravity","x":2,"y":-3,"z":9})"
                                       "\n");
  const JobFolder folder(tilted);
  folder.write("level.jsonl", level_log());
  folder.write("other.jsonl", test::kSmallLog);
  const std::string truth = rendered(folder.job({"a.h5"})).state_sha256;
  const std::string level = rendered(folder.job({"b.h5"}, {}, "level.jsonl")).state_sha256;
  EXPECT_NE(level, truth);  // otherwise this test would say nothing
  for (const char* log : {"level.jsonl", "other.jsonl"}) {
    RenderJob job = folder.job({"c.h5"}, {}, log);
    job.gravity = {2, -3, 9};
    EXPECT_EQ(rendered(job).state_sha256, truth) << log;
  }
}

TEST(Render, ALampThatFollowsGravityStandsUnderTheGravityThatIsUsed) {
  std::string upright = level_log();
  upright.insert(small_header().size(), R"({"t":0,"type":"gravity","x":0,"y":9.81,"z":0})"
                                        "\n");
  const JobFolder folder(upright);
  folder.write("level.jsonl", level_log());
  RenderJob of_log = folder.job({"a.h5"}), of_job = folder.job({"b.h5"}, {}, "level.jsonl");
  of_job.gravity = {0, 9.81, 0};
  of_log.light.follow_gravity = of_job.light.follow_gravity = true;
  rendered(of_log);
  rendered(of_job);
  // The default lamp (-0.48, 0.60, 0.64), turned as z turns into y: about x, so z becomes y and y
  // becomes -z.
  for (const char* file : {"a.h5", "b.h5"}) {
    const auto dump = read_state(folder.path(file));
    ASSERT_TRUE(dump) << dump.error().message;
    const std::array<float, 3>& lamp = dump->lighting.lamps.front().direction;
    EXPECT_NEAR(lamp[0], -0.48f, 1e-6f) << file;  // float rounding
    EXPECT_NEAR(lamp[1], 0.64f, 1e-6f) << file;
    EXPECT_NEAR(lamp[2], -0.60f, 1e-6f) << file;
  }
}

/// Four frames a second, frame i of the even light i / 8.
void write_video(const std::string& path, int frames) {
  VideoOptions options;
  options.width = 32;
  options.height = 18;
  options.frames_per_second = 4;
  auto film = create_video(path, options);
  ASSERT_TRUE(film.ok()) << film.error().message;
  for (int i = 0; i < frames; ++i) {
    const Field<float> plane(32, 18, static_cast<float>(i) / 8);
    ASSERT_TRUE(
        (*film)->write({0, 18, {"R", "G", "B"}, {plane.view(), plane.view(), plane.view()}}).ok());
  }
  ASSERT_TRUE((*film)->finish().ok());
}

/// The frame that the front camera of a dump saw.
int frame_seen(const std::string& path) {
  const auto dump = read_state(path);
  EXPECT_TRUE(dump) << dump.error().message;
  const Field<float>& plane = dump->lighting.reflection.rgb[1];
  return static_cast<int>(std::lround(plane(16, 9) * 8));
}

TEST(Render, AVideoBeginsWithItsEventAlsoWhereACanvasGoesOn) {
  std::string log = test::kSmallLog;
  // In step 9 of the log.
  log.insert(log.find(R"({"t":0.3,)"), R"({"t":0.2,"type":"camera","file":"v.avi"})"
                                       "\n");
  const JobFolder folder(log);
  write_video(folder.path("v.avi"), 8);
  rendered(folder.job({"f-%.h5"}, {"step:10", "0.6", "1"}));
  EXPECT_EQ(frame_seen(folder.path("f-10.h5")), 0);   // 1/45 s into it
  EXPECT_EQ(frame_seen(folder.path("f-0.6.h5")), 1);  // after 28 steps: 19/45 s = 0.42 s into it
  EXPECT_EQ(frame_seen(folder.path("f-1.h5")), 3);    // after 46: 0.82 s
  RenderJob on = folder.job({"g.h5"}, {"0.6"});
  on.from = folder.path("f-1.h5");
  rendered(on);
  EXPECT_EQ(frame_seen(folder.path("g.h5")), 1);
}

TEST(Render, SettlingGoesOnFromTheStop) {
  const JobFolder folder;
  RenderJob job = folder.job({"a.h5"}, {"step:20"});
  job.settle_s = 0.5;
  const JobReport report = rendered(job);
  EXPECT_EQ(report.steps, 20 + 23);  // 22.5 steps, rounded up
  job.stops.push_back(parse_stop_point("step:30").value());
  EXPECT_EQ(render(job, Control()).error().code, ErrorCode::kUsage);
}

}  // namespace
}  // namespace pentimento
