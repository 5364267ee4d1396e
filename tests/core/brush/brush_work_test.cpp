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
