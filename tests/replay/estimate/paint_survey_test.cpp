#include "replay/estimate/paint_survey.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/core/base/resident_memory.h"
#include "tests/core/canvas/set_base.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

/// A log of `events` on 400 x 300 cells, 1 mm each, of a blue and a red.
Result<LogSession> session_of(const test::Scratch& scratch, const std::string& events, int detail,
                              const std::string& optics = "rgb", const RenderJob& more = {}) {
  test::spill(scratch.path("a.jsonl"),
              R"({"type":"header","format":"pentimento-log","version":1,"canvas":{"width":0.4,)"
              R"("height":0.3},"grid":{"width":400,"height":300},"palette":[{"name":"blue",)"
              R"("color":"#1f2f8c"},{"name":"red","color":"#8c2f1f"}],"optics":")" +
                  optics + "\"}\n" + events);
  RenderJob job = more;
  job.log = scratch.path("a.jsonl");
  job.detail = detail;
  return open_session(job, Control());
}

/// A stroke of the round brush, 3 cm wide, across the canvas at height y.
std::string stroke(double t, double y) {
  return fmt::format(R"({{"t":{},"type":"touch","phase":"down","x":0.05,"y":{}}})"
                     "\n"
                     R"({{"t":{},"type":"touch","phase":"up","x":0.35,"y":{}}})"
                     "\n",
                     t, y, t + 0.5, y);
}
std::string line(const std::string& event) {
  return event + "\n";
}
std::string red() {
  return line(R"({"t":1,"type":"color","pigment":"red"})");
}

PaintSurvey survey(const std::string& events, int detail = 8, const RenderJob& more = {}) {
  const test::Scratch scratch;
  auto session = session_of(scratch, events, detail, "rgb", more);
  EXPECT_TRUE(session) << session.error().message;
  auto found = survey_paint(*session, DetailCost());
  EXPECT_TRUE(found) << found.error().message;
  return *found;
}

TEST(PaintSurvey, CountsTheTilesUnderAStroke) {
  // Tiles of 16 cells: 25 x 19. The stroke covers x 35 to 365 mm, y 135 to 165 mm.
  const PaintSurvey found = survey(stroke(0, 0.15));
  EXPECT_EQ(found.all_tiles, 25 * 19);
  EXPECT_EQ(found.tiles, 21 * 3);
  EXPECT_GT(found.stamps, 300);  // 30 cm at a fortieth of 3 cm
  EXPECT_GT(found.stamped_cells, static_cast<double>(found.stamps) * 300);
}

TEST(PaintSurvey, PaintReachesTheTilesNearItAndAllWhereItMayRun) {
  // Sleep tiles of 16 x 16 cells, 25 x 19. The stroke lies in tiles of 32 cells 1 to 11 and 4 to 5.
  const double reached = survey(stroke(0, 0.15)).reached_share;
  EXPECT_EQ(reached, 25.0 * (2 * 4) / (25 * 19));
  const std::string tilt = line(R"({"t":1,"type":"gravity","x":0,"y":9.81,"z":0})");
  EXPECT_EQ(
      survey(stroke(0, 0.15) + tilt + line(R"({"t":2,"type":"mark","name":"end"})")).reached_share,
      1);
}

TEST(PaintSurvey, APigmentMoreTakesItsPlanesAndDryingGivesThemBack) {
  const double relief = 21 * 3 * 128 * 128 * 4, bare = 25 * 19 * 16;
  const double one = survey(stroke(0, 0.15)).detail_bytes - bare;
  // Depth and blue in one layer, of which the pages are given that the stroke covers: a page is a
  // row of the guide here, the stroke 30 rows of the tiles' 48, fewer at its round ends.
  const double plane = (one - relief) / 2;
  EXPECT_NEAR(plane / relief, 30.0 / 48, 0.03);
  // A stroke over it opens the second layer, and stirs both.
  EXPECT_DOUBLE_EQ(survey(stroke(0, 0.15) + red() + stroke(1, 0.15)).detail_bytes - bare,
                   relief + 5 * plane);
  // Dry in between: the second stroke lies on reflectance instead of on the first.
  const std::string dry = line(R"({"t":0.9,"type":"dry"})");
  EXPECT_DOUBLE_EQ(survey(stroke(0, 0.15) + dry + red() + stroke(1, 0.15)).detail_bytes - bare,
                   4 * relief + 2 * plane);
}

TEST(PaintSurvey, ColoursSideBySideAreAllLaid) {
  const std::string half = line(R"({"t":0,"type":"color","pigment":"red","across":[0.5,1]})");
  const double relief = 21 * 3 * 128 * 128 * 4, bare = 25 * 19 * 16;
  const double one = survey(stroke(0, 0.15)).detail_bytes - bare - relief;
  const double both = survey(half + stroke(0, 0.15)).detail_bytes - bare - relief;
  // Each lies in half of the rows, and in those where the tip's texels meet.
  EXPECT_GT(both, 0.97 * one);
  EXPECT_LT(both, 1.2 * one);
}

TEST(PaintSurvey, ThinPaintRunsIntoTilesBelow) {
  const std::string end = line(R"({"t":9,"type":"mark","name":"end"})");
  const std::string thin = line(R"({"t":0,"type":"slider","name":"pigment","value":0.15})");
  const std::string tilt = line(R"({"t":1,"type":"gravity","x":0,"y":9.81,"z":0})");
  EXPECT_EQ(survey(thin + stroke(0, 0.15) + end).tiles, 21 * 3);
  EXPECT_EQ(survey(stroke(0, 0.15) + tilt + end).tiles, 21 * 3);
  // The lower edge at y = 165, drips down to 255 mm: in rows of tiles 8 to 15.
  const std::int64_t ran = survey(thin + stroke(0, 0.15) + tilt + end).tiles;
  EXPECT_GT(ran, 21 * 4);
  EXPECT_LT(ran, 21 * 8);
}

TEST(PaintSurvey, DriedPaintTakesAPlaneForEveryBand) {
  const test::Scratch scratch;
  const std::string dry = line(R"({"t":0.9,"type":"dry"})");
  auto wet = session_of(scratch, stroke(0, 0.15), 8, "spectral");
  ASSERT_TRUE(wet) << wet.error().message;
  const int bands = wet->basis.bands();
  ASSERT_GT(bands, 3);
  const Result<PaintSurvey> once = survey_paint(*wet, DetailCost());
  auto dried = session_of(scratch, stroke(0, 0.15) + dry + stroke(1, 0.15), 8, "spectral");
  ASSERT_TRUE(dried) << dried.error().message;
  const Result<PaintSurvey> twice = survey_paint(*dried, DetailCost());
  ASSERT_TRUE(once && twice);
  const double cells = 21 * 3 * 128 * 128;
  EXPECT_DOUBLE_EQ(twice->detail_bytes - once->detail_bytes, cells * bands * 4);
}

TEST(PaintSurvey, ThinPaintMovesLonger) {
  const std::string end = line(R"({"t":9,"type":"mark","name":"end"})");
  const std::string thin = line(R"({"t":0,"type":"slider","name":"pigment","value":0.15})");
  const double usual = survey(stroke(0, 0.15) + end).awake.cell_steps;
  const double runny = survey(thin + stroke(0, 0.15) + end).awake.cell_steps;
  EXPECT_GT(runny, 2 * usual);  // medium 0.5: 31 steps in place of 9 after the last touch
}

TEST(PaintSurvey, TiltedPaintStaysAwake) {
  const std::string end = line(R"({"t":9,"type":"mark","name":"end"})");
  const std::string tilt = line(R"({"t":1,"type":"gravity","x":3,"y":0,"z":9})");
  const PaintSurvey flat = survey(stroke(0, 0.15) + end);
  EXPECT_EQ(flat.tilted_cell_steps, 0);
  // 8 s of 45 steps besides 9 after each tile's last touch.
  EXPECT_GT(survey(stroke(0, 0.15) + tilt + end).tilted_cell_steps, 10 * flat.awake.cell_steps);
}

TEST(PaintSurvey, AGivenGravityStandsInPlaceOfTheLogs) {
  const std::string thin = line(R"({"t":0,"type":"slider","name":"pigment","value":0.15})");
  const std::string end = line(R"({"t":9,"type":"mark","name":"end"})");
  const std::string tilt = line(R"({"t":1,"type":"gravity","x":0,"y":9.81,"z":0})");
  RenderJob lying, upright;
  lying.gravity = {0, 0, 9.81};
  upright.gravity = {0, 9.81, 0};
  const std::string flat = thin + stroke(0, 0.15) + end;
  const std::string tilted = thin + stroke(0, 0.15) + tilt + end;
  EXPECT_GT(survey(tilted).tilted_cell_steps, 0);
  const PaintSurvey laid_down = survey(tilted, 8, lying);
  EXPECT_EQ(laid_down.tilted_cell_steps, 0);
  EXPECT_EQ(laid_down.tiles, 21 * 3);  // nothing runs down
  EXPECT_EQ(survey(flat).tilted_cell_steps, 0);
  const PaintSurvey stood_up = survey(flat, 8, upright);
  // From the first step on, not from 1 s.
  EXPECT_GT(stood_up.tilted_cell_steps, survey(tilted).tilted_cell_steps);
  EXPECT_GT(stood_up.tiles, 21 * 4);
}

TEST(PaintSurvey, WhatFollowsTheStopIsNotPaintedThoughTheSessionSettles) {
  RenderJob job;
  job.stops = {*parse_stop_point("1")};
  job.settle_s = 3;
  const PaintSurvey first = survey(stroke(0, 0.15));
  const PaintSurvey stopped = survey(stroke(0, 0.15) + stroke(2, 0.05), 8, job);
  EXPECT_EQ(stopped.stamps, first.stamps);
  EXPECT_EQ(stopped.tiles, first.tiles);
}

TEST(PaintSurvey, CountsWhatADumpBrings) {
  const test::Scratch scratch;
  Result<LogSession> session = session_of(scratch, stroke(0, 0.1), 8);
  ASSERT_TRUE(session);
  const Result<PaintSurvey> fresh = survey_paint(*session, DetailCost());
  session->start.emplace();
  CanvasState& state = session->start->state;
  state = make_canvas_state(session->grid, session->model.layers, session->basis.channels(), 3, 1);
  for (int y = 200; y < 232; ++y) {
    state.pigment[1].row(y)[100] = 0.1f;  // red, two tiles of 16 cells high
    set_base(state, 300, y, 1e-4f);       // dried, in others
  }
  const Result<PaintSurvey> more = survey_paint(*session, DetailCost());
  ASSERT_TRUE(fresh && more);
  EXPECT_EQ(more->tiles, fresh->tiles + 6);  // 200 to 231 lies in three rows of tiles
  EXPECT_GT(more->detail_bytes, fresh->detail_bytes);
}

TEST(PaintSurvey, OnALargeCanvasTakesMemoryWhereThereIsPaint) {
  if (is_marked_when_given()) GTEST_SKIP();
  const test::Scratch scratch;
  Result<LogSession> session = session_of(scratch, stroke(0, 0.15), 1);
  ASSERT_TRUE(session);
  session->grid.width = session->grid.height = 4096;
  const long before_mib = resident_mib();
  const Result<PaintSurvey> found = survey_paint(*session, DetailCost());
  ASSERT_TRUE(found);
  // The stroke covers 330 x 30 mm of a canvas of 400 x 300, a twelfth of 336 MB for wet cells.
  EXPECT_GT(found->stamps, 300);
  EXPECT_LT(resident_mib() - before_mib, 120);
}

TEST(PaintSurvey, StopsWhereItIsToldTo) {
  const test::Scratch scratch;
  Result<LogSession> session = session_of(scratch, stroke(0, 0.1) + stroke(2, 0.2), 8);
  ASSERT_TRUE(session);
  std::atomic<bool> stop = false;
  std::int64_t last_step = 0;
  Control control;
  control.cancelled = &stop;
  control.progress = [&](const ProgressState& state) {
    last_step = state.done;
    stop = state.done >= 9;  // 0.2 s
  };
  const Result<PaintSurvey> survey = survey_paint(*session, DetailCost(), control);
  ASSERT_FALSE(survey);
  EXPECT_EQ(survey.error().code, ErrorCode::kInterrupted);
  EXPECT_LT(last_step, 23);  // before the first stroke was over
}

}  // namespace
}  // namespace pentimento
