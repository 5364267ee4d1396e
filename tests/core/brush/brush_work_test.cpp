// What brushes do to paint, through the simulation: dry brush, knife, rag, two colours.

#include <gtest/gtest.h>

#include <cmath>

#include "core/brush/builtin_brushes.h"
#include "core/brush/stroke_path.h"
#include "core/optics/paints/pigment_library.h"
#include "core/simulation/simulation.h"

namespace pentimento {
namespace {

constexpr int kWidth = 160, kHeight = 80;
constexpr double kWidth_m = 0.32, kHeight_m = 0.16;

SimulationSetup canvas(float relief_m = 0) {
  SimulationSetup setup;
  setup.geometry = {kWidth, kHeight, kWidth_m, kHeight_m};
  setup.basis = palette_channels(
      {*find_library_pigment("Vermilion"), *find_library_pigment("Ultramarine Blue")});
  setup.paper_m = Field<float>(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y)  // a weave of single cells
    for (int x = 0; x < kWidth; ++x) setup.paper_m(x, y) = (x + y) % 2 == 0 ? relief_m : 0;
  return setup;
}

void stroke(Simulation& sim, std::uint32_t id, float pressure, double y_m = 0.08) {
  StrokePath path(0.02, kWidth_m, kHeight_m);
  std::vector<Stamp> stamps;
  TouchSample sample;
  sample.diameter_m = 0.06f;
  sample.pressure = pressure;
  sample.x_m = 0.05;
  sample.y_m = y_m;
  path.begin(sample);
  sample.x_m = 0.27;
  sample.time_s = 1;
  path.add(sample, stamps);
  path.finish(stamps);
  sim.begin_stroke(0, id);
  for (const Stamp& s : stamps) sim.stamp(0, s);
  sim.end_stroke(0);
}

struct PeaksAndHollows {
  double peaks = 0, hollows = 0;
};

PeaksAndHollows deposited(float load, float pressure) {
  const Threads threads(1);
  Simulation sim(canvas(3e-4f), threads);
  sim.set_brush(*builtin_brush("bristle"));
  BrushSettings settings;
  settings.load_frac = load;
  sim.set_settings(settings);
  stroke(sim, 1, pressure);
  PeaksAndHollows sums;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      ((x + y) % 2 == 0 ? sums.peaks : sums.hollows) +=
          static_cast<double>(sim.state().depth_m(x, y));
  return sums;
}

TEST(DryBrush, CatchesThePeaksOfTheWeave) {
  const PeaksAndHollows wet = deposited(1, 1), dry = deposited(0.3f, 1), light = deposited(1, 0.1f);
  EXPECT_GT(wet.hollows, wet.peaks);  // levelled: more in hollows
  EXPECT_GT(dry.peaks, 4 * dry.hollows);
  EXPECT_GT(light.peaks, 2 * light.hollows);
  EXPECT_LT(dry.peaks + dry.hollows, 0.5 * (wet.peaks + wet.hollows));
}

/// A straight stroke of a second over 280 mm, in the middle of the canvas.
struct Line {
  const char* brush = "rigger";
  float diameter_m = 0.02f;
  float load = 1;
  float pressure = 1;
  double step_s = 0;  // of its time is a step of the fluid; 0: the fluid does not move
  bool down = false;  // the canvas is turned, and the stroke goes down
};

/// How unevenly it lies between 120 and 200 mm: the deviation of the amount across it, over its
/// mean.
double unevenness(const Line& line) {
  const Threads threads(1);
  const bool down = line.down;
  SimulationSetup setup = canvas();
  if (down) setup.geometry = {kHeight, kWidth, kHeight_m, kWidth_m};
  setup.paper_m = Field<float>(setup.geometry.width, setup.geometry.height);
  Simulation sim(std::move(setup), threads);
  sim.set_brush(*builtin_brush(line.brush));
  BrushSettings settings;
  settings.load_frac = line.load;
  sim.set_settings(settings);
  StrokePath path(0.02, down ? kHeight_m : kWidth_m, down ? kWidth_m : kHeight_m);
  std::vector<Stamp> stamps;
  TouchSample sample;
  sample.diameter_m = line.diameter_m;
  sample.pressure = line.pressure;
  (down ? sample.x_m : sample.y_m) = 0.08;
  double& along_m = down ? sample.y_m : sample.x_m;
  along_m = 0.02;
  path.begin(sample);
  along_m = 0.3;
  sample.time_s = 1;
  path.add(sample, stamps);
  path.finish(stamps);
  sim.begin_stroke(0, 1);
  double next_s = line.step_s;
  for (const Stamp& s : stamps) {
    sim.stamp(0, s);
    const double time_s = ((down ? s.y_m : s.x_m) - 0.02) / 0.28;
    if (line.step_s == 0 || time_s < next_s) continue;
    sim.step();
    next_s += line.step_s;
  }
  if (line.step_s > 0) sim.step();
  double sum = 0, square = 0;
  constexpr int kFirst = 60, kLast = 100;  // cells of 2 mm
  for (int i = kFirst; i < kLast; ++i) {
    double amount = 0;
    for (int j = 0; j < kHeight; ++j)
      amount += static_cast<double>(down ? sim.state().depth_m(j, i) : sim.state().depth_m(i, j));
    sum += amount;
    square += amount * amount;
  }
  const double mean = sum / (kLast - kFirst);
  if (!(mean > 0)) return 1e9;
  return std::sqrt(std::max(0.0, square / (kLast - kFirst) - mean * mean)) / mean;
}

TEST(DryBrush, ALightLineOnSmoothGroundIsEven) {
  // Where the paint that the stroke has just laid catches more of it, this is 0.79: lumps. What is
  // left, 0.008, is the fading of a brush that empties.
  EXPECT_LT(unevenness({.load = 0.5f, .pressure = 0.1f}), 0.02);
}

TEST(DryBrush, AnEmptyingBrushPaintsOnSmoothGround) {
  // Smooth ground has no hollows that the bristles could pass over: 0.0045; it was 0.96.
  EXPECT_LT(unevenness({.load = 0.3f}), 0.02);
}

TEST(DryBrush, ASecondPassLeavesTheHollows) {
  const Threads threads(1);
  Simulation sim(canvas(6e-4f), threads);
  sim.set_brush(*builtin_brush("bristle"));
  BrushSettings settings;
  settings.load_frac = 0.3f;
  sim.set_settings(settings);
  const auto share_of_hollows = [&] {
    double hollows = 0, all = 0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const double depth = static_cast<double>(sim.state().depth_m(x, y));
        all += depth;
        if ((x + y) % 2 != 0) hollows += depth;
      }
    return hollows / all;
  };
  stroke(sim, 1, 1);
  const double first = share_of_hollows();
  stroke(sim, 2, 1);
  // The first film is thinner than the weave is deep: it drowns little of it.
  EXPECT_NEAR(share_of_hollows(), first, 0.02);
}

// Paint is pushed by the stamps after it, not by those before: that left ribs of 0.018. Without
// steps the stroke has 0.0021, with them 0.0024.
TEST(Stroke, HasNoRibsWhereStepsMeet) {
  EXPECT_LT(unevenness({.brush = "flat", .diameter_m = 0.06f, .step_s = 0.05}), 0.004);
}

TEST(Stroke, HasNoRibsDownTheCanvasEither) {
  EXPECT_LT(unevenness({.brush = "flat", .diameter_m = 0.06f, .step_s = 0.05, .down = true}),
            0.004);
}

/// What a tap of 60 mm leaves: how far the paint reaches along each axis, as the root of its second
/// moment, and its greatest depth.
struct Dab {
  double wide_m = 0, high_m = 0, deepest_m = 0;
};

Dab dab_of(const char* brush) {
  const Threads threads(1);
  Simulation sim(canvas(), threads);
  sim.set_brush(*builtin_brush(brush));
  StrokePath path(0.02, kWidth_m, kHeight_m);
  std::vector<Stamp> stamps;
  TouchSample sample;
  sample.diameter_m = 0.06f;
  sample.x_m = kWidth_m / 2;
  sample.y_m = kHeight_m / 2;
  path.begin(sample);
  path.finish(stamps);
  sim.begin_stroke(0, 1);
  for (const Stamp& s : stamps) sim.stamp(0, s);
  double sum = 0, xx = 0, yy = 0;
  Dab dab;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const double depth = static_cast<double>(sim.state().depth_m(x, y));
      const double dx = (x + 0.5) * 0.002 - sample.x_m, dy = (y + 0.5) * 0.002 - sample.y_m;
      sum += depth;
      xx += depth * dx * dx;
      yy += depth * dy * dy;
      dab.deepest_m = std::max(dab.deepest_m, depth);
    }
  dab.wide_m = std::sqrt(xx / sum);
  dab.high_m = std::sqrt(yy / sum);
  return dab;
}

TEST(Tap, OfARoundBrushIsADisc) {
  for (const char* brush : {"round", "rigger"}) {
    const Dab dab = dab_of(brush);
    EXPECT_NEAR(dab.wide_m / dab.high_m, 1, 0.02) << brush;  // cells of a thirtieth of it
  }
  // 1 mm is its film, where all of it is laid.
  EXPECT_LT(dab_of("round").deepest_m, 0.002);
}

TEST(Tap, OfAFlatBrushIsItsLineAndNoHeap) {
  // Its print is a sixth as wide as high. What half a diameter of way takes would be 4 mm deep.
  for (const char* brush : {"flat", "filbert", "bristle", "fan"}) {
    const Dab dab = dab_of(brush);
    EXPECT_LT(dab.wide_m, 0.5 * dab.high_m) << brush;
    EXPECT_LT(dab.deepest_m, 0.0035) << brush;
    EXPECT_GT(dab.deepest_m, 0.0005) << brush;
  }
}

double wet_medium(const Simulation& sim) {
  return sim.wet().medium_m3;
}

TEST(Knife, ScrapesDownToItsEdgeAndKeepsThePaint) {
  const Threads threads(1);
  Simulation sim(canvas(), threads);
  for (std::uint32_t id = 1; id <= 3; ++id) stroke(sim, id, 1);
  const auto thickest = [&] {
    float most = 0;
    for (int x = 60; x < 120; ++x) most = std::max(most, sim.state().depth_m(x, kHeight / 2));
    return most;
  };
  const float before = thickest();
  BrushSettings clean;
  clean.medium_frac = clean.pigment_frac = 0;
  sim.set_settings(clean);
  sim.set_brush(*builtin_brush("knife"));
  stroke(sim, 4, 1);
  // The edge rides 0.15 mm above the canvas; what is spread back into the track is thin.
  EXPECT_LT(thickest(), 0.35f * before);
  const PaintAccount& account = sim.account();
  EXPECT_NEAR(account.deposited.medium_m3 - account.picked_up.medium_m3, wet_medium(sim),
              1e-9 * account.deposited.medium_m3);  // the books are exact sums of float changes
}

TEST(Rag, TakesPaintAwayAndLaysNone) {
  const Threads threads(1);
  Simulation sim(canvas(), threads);
  stroke(sim, 1, 1);
  const double before = wet_medium(sim);
  const double deposited = sim.account().deposited.medium_m3;
  sim.set_brush(*builtin_brush("rag"));
  stroke(sim, 2, 1);
  EXPECT_LT(wet_medium(sim), 0.6 * before);
  // Soaked beyond a load it smears a little of what it took.
  EXPECT_LT(sim.account().deposited.medium_m3 - deposited, 0.1 * before);
}

TEST(TwoColours, LieSideBySideInOneStroke) {
  const Threads threads(1);
  Simulation sim(canvas(), threads);
  sim.set_brush(*builtin_brush("flat"));
  sim.set_color(0);
  sim.set_color(1, 0.5f, 1);
  stroke(sim, 1, 1);
  const auto amount = [&](int channel, double y_m) {
    const int y = static_cast<int>(y_m / kHeight_m * kHeight);
    double sum = 0;
    for (int x = 60; x < 100; ++x)
      for (int layer = 0; layer < sim.state().layers; ++layer)
        sum += static_cast<double>(sim.state().channel(layer, channel)(x, y));
    return sum;
  };
  // Travelling right, the left of the stroke is the upper side.
  EXPECT_GT(amount(0, 0.065), 20 * amount(1, 0.065));
  EXPECT_GT(amount(1, 0.095), 20 * amount(0, 0.095));
  sim.set_color(0);  // a colour without a side is all of the brush again
  stroke(sim, 2, 1, 0.03);
  EXPECT_EQ(amount(1, 0.03), 0);
}

}  // namespace
}  // namespace pentimento
