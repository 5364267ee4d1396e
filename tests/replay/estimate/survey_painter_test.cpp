#include "replay/estimate/survey_painter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/brush/builtin_brushes.h"
#include "core/simulation/simulation.h"
#include "replay/estimate/detail_cost.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

constexpr std::uint32_t kBlue = 1, kRed = 2;

/// A session on 200 x 150 cells, 2 mm each, with blue, red and white.
LogSession session_of(const test::Scratch& scratch) {
  test::spill(scratch.path("a.jsonl"),
              R"({"type":"header","format":"pentimento-log","version":1,"canvas":{"width":0.4,)"
              R"("height":0.3},"grid":{"width":200,"height":150},"paper":{"relief":0},"palette":[)"
              R"({"name":"blue","color":"#1f2f8c"},{"name":"red","color":"#8c2f1f"},)"
              R"({"name":"white","color":"#f0f0f0"}]})"
              "\n");
  RenderJob job;
  job.log = scratch.path("a.jsonl");
  return std::move(*open_session(job, Control()));
}

/// From (x0, y) to (x1, y), a stamp every millimetre.
void stroke(Painter& painter, int touch, std::uint32_t id, double x0, double x1, double y) {
  painter.begin_stroke(touch, id);
  const double way = x1 - x0;
  for (double s = 0; s < std::abs(way); s += 0.001) {
    Stamp stamp;
    stamp.x_m = x0 + (way > 0 ? s : -s);
    stamp.y_m = y;
    stamp.diameter_m = 0.04f;
    stamp.direction = stamp.heading = {way > 0 ? 1.0f : -1.0f, 0};
    stamp.travel_m = 0.001f;
    painter.stamp(touch, stamp);
  }
  painter.end_stroke(touch);
}

class SurveyPainterTest : public testing::Test {
 protected:
  /// What lies at a place of the map.
  std::uint32_t at(double x_m, double y_m) const {
    return painter_.map().wet_channels(static_cast<int>(x_m / 0.002),
                                       static_cast<int>(y_m / 0.002));
  }

  const test::Scratch scratch_;
  LogSession session_ = session_of(scratch_);
  SurveyPainter painter_{session_, DetailCost()};
};

TEST_F(SurveyPainterTest, TwoTouchesCarryTheirOwnPaint) {
  painter_.set_color(0);
  stroke(painter_, 0, 1, 0.05, 0.15, 0.1);
  painter_.set_color(1);
  stroke(painter_, 0, 2, 0.05, 0.2, 0.1);   // the first takes blue along
  stroke(painter_, 1, 3, 0.25, 0.35, 0.1);  // the second has never met it
  EXPECT_EQ(at(0.1, 0.1), kBlue | kRed);
  EXPECT_EQ(at(0.17, 0.1), kBlue | kRed);
  EXPECT_EQ(at(0.3, 0.1), kRed);
}

TEST_F(SurveyPainterTest, ABrushStaysDirtyUntilAnotherOrAnotherLoadIsTaken) {
  painter_.set_color(0);
  const auto dirty = [&] {  // the red brush in the hand has been through blue
    painter_.clear();
    painter_.set_color(0);
    stroke(painter_, 0, 1, 0.05, 0.15, 0.1);
    painter_.set_color(1);
    stroke(painter_, 0, 2, 0.05, 0.15, 0.1);
  };
  const auto lays = [&] {
    stroke(painter_, 0, 3, 0.2, 0.23, 0.2);
    return at(0.2, 0.2);
  };
  dirty();
  EXPECT_EQ(lays(), kBlue | kRed);
  dirty();
  painter_.set_brush(*builtin_brush("round"));  // it is in the hand
  EXPECT_EQ(lays(), kBlue | kRed);
  dirty();
  painter_.set_brush(*builtin_brush("flat"));
  EXPECT_EQ(lays(), kRed);
  painter_.set_brush(*builtin_brush("round"));
  dirty();
  BrushSettings settings;
  settings.pickup = 0.31f;  // says nothing of what the brush holds
  painter_.set_settings(settings);
  EXPECT_EQ(lays(), kBlue | kRed);
  dirty();
  settings.medium_frac = 0.4f;
  painter_.set_settings(settings);
  EXPECT_EQ(lays(), kRed);
}

TEST_F(SurveyPainterTest, AFreshCanvasHasNothingWet) {
  stroke(painter_, 0, 1, 0.05, 0.15, 0.1);
  ASSERT_EQ(at(0.1, 0.1), kBlue);
  painter_.load({});
  EXPECT_EQ(at(0.1, 0.1), 0u);
  stroke(painter_, 0, 1, 0.05, 0.15, 0.1);
  painter_.clear();
  EXPECT_EQ(at(0.1, 0.1), 0u);
  stroke(painter_, 0, 1, 0.05, 0.15, 0.1);
  painter_.dry();
  EXPECT_EQ(at(0.1, 0.1), 0u);
}

TEST_F(SurveyPainterTest, GravityAlongTheCanvasIsCountedFromWhenItIsTold) {
  stroke(painter_, 0, 1, 0.05, 0.15, 0.1);
  painter_.pass_to(10);
  painter_.set_gravity({0, 0, 9.81f});
  painter_.pass_to(20);
  painter_.set_gravity({0, -5, 8});
  const PaintSurvey survey = painter_.finish(50);
  // x 3 to 17 cm is cells 15 to 85, y 8 to 12 cm cells 40 to 60: 3 x 1 tiles of 32 cells, 30 steps.
  EXPECT_EQ(survey.tilted_cell_steps, 30 * 3 * 32 * 32);
}

/// The map foresees what the simulation gets of the same hand.
class SameHand : public SurveyPainterTest {
 protected:
  /// Counted by cells and channels.
  struct Compared {
    int painted = 0;   // a hundredth of a film at least lies in the simulation...
    int foreseen = 0;  // ...of them, on the map too
    int more = 0;      // on the map, where the simulation has less than it can keep
  };
  Compared compare(const std::function<void(Painter&)>& hand) {
    SimulationSetup setup;
    setup.geometry = session_.grid;
    setup.model = session_.model;
    setup.basis = session_.basis;
    setup.paper_m = Field<float>(session_.grid.width, session_.grid.height);
    const Threads one(1);
    Simulation simulation(std::move(setup), one);
    hand(simulation);
    hand(painter_);
    Compared compared;
    for (int y = 0; y < session_.grid.height; ++y)
      for (int x = 0; x < session_.grid.width; ++x) add(simulation.state(), x, y, compared);
    return compared;
  }

 private:
  void add(const CanvasState& state, int x, int y, Compared& compared) const {
    constexpr float kFilm = 0.04f * 0.7f;  // the model's and the slider's defaults
    constexpr float kRounded = 0x1p-23f;   // half a quantum of the fluid's
    for (int c = 0; c < state.channels; ++c) {
      float most = 0;
      for (int layer = 0; layer < state.layers; ++layer)
        most = std::max(most, state.channel(layer, c)(x, y));
      const bool foreseen = (painter_.map().wet_channels(x, y) >> c & 1) != 0;
      compared.painted += most > kFilm / 100 ? 1 : 0;
      compared.foreseen += most > kFilm / 100 && foreseen ? 1 : 0;
      compared.more += most < kRounded && foreseen ? 1 : 0;
    }
  }
};

// The map asks for the tip at a cell's centre, the simulation for its mean over the cell, and a
// band of the tip is as fine as eight across: a cell on each side of a stroke of twenty may differ,
// and one between two colours.
constexpr double kRims = 0.08;

TEST_F(SameHand, ThreeColoursTwoTouchesAndHalfATip) {
  const Compared found = compare([](Painter& painter) {
    painter.set_color(0);
    stroke(painter, 0, 1, 0.05, 0.3, 0.1);
    painter.set_color(1);
    painter.set_color(2, 0.5f, 1);
    stroke(painter, 0, 2, 0.25, 0.35, 0.2);
    stroke(painter, 1, 3, 0.1, 0.2, 0.11);
    painter.set_brush(*builtin_brush("flat"));
    stroke(painter, 1, 4, 0.3, 0.1, 0.25);
  });
  ASSERT_GT(found.painted, 5000);
  EXPECT_GT(found.foreseen, (1 - kRims) * found.painted);
  EXPECT_LT(found.more, kRims * found.painted);
}

TEST_F(SameHand, ARagThroughWetPaint) {
  const Compared found = compare([](Painter& painter) {
    painter.set_color(0);
    stroke(painter, 0, 1, 0.05, 0.2, 0.1);
    painter.set_color(1);
    painter.set_brush(*builtin_brush("rag"));
    stroke(painter, 0, 2, 0.15, 0.3, 0.1);
  });
  ASSERT_GT(found.painted, 1000);
  EXPECT_GT(found.foreseen, (1 - kRims) * found.painted);
  EXPECT_EQ(at(0.25, 0.1) & kRed, 0u);  // it was not dipped
  // It gives a hundredth of it back, mostly less than can be kept: the map counts that all the
  // same.
}

}  // namespace
}  // namespace pentimento
