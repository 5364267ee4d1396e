#include "replay/estimate/time_estimate.h"

#include <gtest/gtest.h>

#include "replay/estimate/detail_cost.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

/// On 400 x 300 cells.
LogSession session_of(const test::Scratch& scratch, int detail) {
  test::spill(scratch.path("a.jsonl"),
              R"({"type":"header","format":"pentimento-log","version":1,"canvas":{"width":0.4,)"
              R"("height":0.3},"grid":{"width":400,"height":300}})"
              "\n");
  RenderJob job;
  job.log = scratch.path("a.jsonl");
  job.detail = detail;
  return std::move(*open_session(job, Control()));
}

PaintSurvey survey() {
  PaintSurvey survey;
  survey.stamps = 1000;
  survey.stamped_cells = 50'000;
  survey.stamped_channels = 150'000;
  survey.awake = {2e6, 5e6};
  survey.tilted_cell_steps = 3e6;
  return survey;
}

double seconds(const LogSession& session, const PaintSurvey& survey, double cell_step_s,
               int threads) {
  return job_seconds(RenderJob(), session, survey, {400, 300, 0}, cell_step_s, threads);
}

TEST(TimeEstimate, IsTheSumOfItsPartsOnOneThread) {
  const test::Scratch scratch;
  const TimeCost cost;
  const double c = 1e-7;
  const double picture = 120'000 * (cost.picture_pixel + cost.canvas_cell);
  const double guide =
      2e6 * cost.awake_cell + 3e6 * cost.tilted_cell + 5e4 * cost.stamped_cell + 1000 * cost.stamp;
  const LogSession plain = session_of(scratch, 1);
  const double start_s = seconds(plain, PaintSurvey(), 0, 1);
  EXPECT_NEAR(seconds(plain, survey(), c, 1), start_s + c * (guide + picture), 1e-9);
  const double followed = 5e4 * cost.followed_cell + 3e6 * cost.followed_tilted_cell;
  const double fine = 16 * (2e6 * cost.fine_awake_cell + 5e6 * cost.fine_awake_channel +
                            3e6 * cost.fine_tilted_cell);
  const double canvas = 15 * 120'000 * cost.canvas_cell;  // hashed
  EXPECT_NEAR(seconds(session_of(scratch, 4), survey(), c, 1),
              start_s + c * (guide + picture + followed + fine + canvas), 1e-9);
}

TEST(TimeEstimate, ThreadsHelpButOnlyWithWhatTheyShare) {
  const test::Scratch scratch;
  const LogSession session = session_of(scratch, 4);
  const double one = seconds(session, survey(), 1e-7, 1), two = seconds(session, survey(), 1e-7, 2);
  EXPECT_LT(two, one);
  EXPECT_GT(two, one / 2);
}

}  // namespace
}  // namespace pentimento
