#include "replay/session/log_session.h"

#include <gtest/gtest.h>

#include "formats/hdf5/state_dump.h"
#include "tests/replay/small_job.h"

namespace pentimento {
namespace {

using test::JobFolder;

/// kSmallLog with `member` put first into its header.
std::string with_header(const std::string& member) {
  return "{" + member + "," + test::kSmallLog.substr(1);
}

/// A folder with kSmallLog's painting at rest, `rest.h5`, and a log that goes on from it.
struct AtRest {
  JobFolder folder;
  explicit AtRest(const std::string& log) {
    RenderJob job = folder.job({"rest.h5"});
    job.settle_s = 10;
    test::rendered(job);
    folder.write("more.jsonl", log);
  }
  RenderJob job() const {
    RenderJob job = folder.job({"more.h5"}, {}, "more.jsonl");
    job.from = folder.path("rest.h5");
    return job;
  }
  std::vector<float> slept() const {
    const auto dump = read_state(folder.path("rest.h5"));
    EXPECT_TRUE(dump) << dump.error().message;
    return dump->state.sleep;
  }
};

std::vector<float> sleep_of(const RenderJob& job) {
  const auto session = open_session(job, Control());
  EXPECT_TRUE(session) << session.error().message;
  return session->start->state.sleep;
}

TEST(LogSession, WhatSleptSleepsOnInTheSameModelAtTheSameRate) {
  const AtRest rest(test::kSmallLog);
  ASSERT_FALSE(rest.slept().empty());  // otherwise these tests would say nothing
  EXPECT_EQ(sleep_of(rest.job()), rest.slept());
}

TEST(LogSession, WhatSleptIsWokenByAnotherStepRate) {
  const AtRest rest(with_header(R"("steps_per_second":60)"));
  EXPECT_TRUE(sleep_of(rest.job()).empty());
}

TEST(LogSession, WhatSleptIsWokenByAnotherModel) {
  const AtRest rest(test::kSmallLog);
  RenderJob job = rest.job();
  job.model = {{"nu_max", "0.02"}};
  EXPECT_TRUE(sleep_of(job).empty());
}

TEST(LogSession, ThePaletteOfADumpIsJoinedAndTheFirstColourIsTheLogs) {
  std::string log = test::kSmallLog;
  log.replace(log.find(R"({"name":"blue")"), 0, R"({"name":"Cobalt Blue"},)");
  const AtRest rest(log);
  const auto session = open_session(rest.job(), Control());
  ASSERT_TRUE(session) << session.error().message;
  std::vector<std::string> names;
  for (const Pigment& pigment : session->palette.pigments()) names.push_back(pigment.name);
  EXPECT_EQ(names, (std::vector<std::string>{"blue", "red", "#e0c020", "Cobalt Blue"}));
  EXPECT_EQ(session->first_color, 3);
  EXPECT_EQ(session->basis.channels(), 4);
  EXPECT_EQ(session->start->state.channels, 4);
}

TEST(LogSession, AnotherCanvasIsRefusedAnotherGridGivesWay) {
  std::string wider = test::kSmallLog;
  wider.replace(wider.find(R"("width":0.4)"), 11, R"("width":0.5)");
  const AtRest rest(wider);
  const auto refused = open_session(rest.job(), Control());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kBadInput);
  std::string finer = test::kSmallLog;
  finer.replace(finer.find(R"("width":80,"height":60)"), 22, R"("width":160,"height":120)");
  rest.folder.write("more.jsonl", finer);
  const auto session = open_session(rest.job(), Control());
  ASSERT_TRUE(session) << session.error().message;
  EXPECT_EQ(session->grid.width, 80);
  EXPECT_EQ(session->grid.height, 60);
}

TEST(LogSession, TheLayersAreThoseOfTheDump) {
  const AtRest rest(with_header(R"("model":{"layers":4})"));
  const auto session = open_session(rest.job(), Control());
  ASSERT_TRUE(session) << session.error().message;
  EXPECT_EQ(session->model.layers, 2);
}

TEST(LogSession, IsAsLongAsItsLastStopAndWhatSettlesAfterIt) {
  const JobFolder folder;
  RenderJob job = folder.job({"a.h5"});
  EXPECT_EQ(open_session(job, Control())->steps, 55);
  job.settle_s = 0.1;  // 4.5 steps
  EXPECT_EQ(open_session(job, Control())->steps, 55 + 5);
  job = folder.job({"%.h5"}, {"step:30", "step:12"});
  EXPECT_EQ(open_session(job, Control())->steps, 30);
}

TEST(LogSession, TheSizeDecidesHowMuchFinerTheCanvasIs) {
  const JobFolder folder;
  RenderJob job = folder.job({"a.png"});
  EXPECT_EQ(open_session(job, Control())->detail, 1);
  job.size.width = 161;
  EXPECT_EQ(open_session(job, Control())->detail, 3);
  job.detail = 2;
  EXPECT_EQ(open_session(job, Control())->detail, 2);
  job.detail.reset();
  job.sim_scale = 0.5;  // and with it --refine direct
  const auto direct = open_session(job, Control());
  ASSERT_TRUE(direct) << direct.error().message;
  EXPECT_EQ(direct->detail, 1);
  EXPECT_EQ(direct->grid.width, 81);  // half of 161 x 121
  EXPECT_EQ(direct->grid.height, 61);
}

TEST(LogSession, WarnsOfWhatItDoesNotDo) {
  const JobFolder folder(with_header(R"("x-a":1)") + R"({"t":2,"type":"redo"})" + "\n");
  std::vector<std::string> warnings;
  Control control;
  control.warn = [&](const std::string& text) { warnings.push_back(text); };
  ASSERT_TRUE(open_session(folder.job({"a.h5"}), control));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].substr(0, 2), "1 ");
}

}  // namespace
}  // namespace pentimento
