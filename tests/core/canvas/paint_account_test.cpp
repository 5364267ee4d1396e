// How far the account of the paint may be off: by the rounding to quanta (docs/numerics.md), which
// is all that a relative difference of a speck shows.

#include "core/canvas/paint_account.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/brush/stroke_path.h"
#include "core/fluid/conservative/tiles/quantum.h"
#include "core/simulation/simulation.h"
#include "tests/core/three_pigments.h"

namespace pentimento {
namespace {

constexpr int kSteps = 120;
// Of the sums of floats that two layers exchange: 6e-8 for each stamp and cell (mixing, merging).
constexpr double kExchange = 1e-6;

SimulationSetup coarse_canvas() {
  SimulationSetup setup;
  setup.geometry = {40, 30, 0.2, 0.15};
  setup.model.scheme = SchemeKind::kConservative;
  setup.basis = palette_channels(test::three_pigments());
  return setup;
}

/// A line through the canvas with a few stamps in each of `kSteps` steps.
void paint_line(Simulation& sim, const BrushSettings& settings) {
  sim.set_settings(settings);
  sim.begin_stroke(0, 1);
  StrokePath path(0.5, sim.geometry().width_m, sim.geometry().height_m);
  for (int step = 0; step <= kSteps; ++step) {
    TouchSample sample;
    sample.x_m = 0.02 + 0.16 * step / kSteps;
    sample.y_m = 0.07;
    sample.time_s = step;  // slow: a thin tip that is fast leaves nothing
    sample.diameter_m = settings.size_m;
    std::vector<Stamp> stamps;
    if (step == 0) {
      path.begin(sample);
      continue;
    }
    path.add(sample, stamps);
    for (const Stamp& stamp : stamps) sim.stamp(0, stamp);
    sim.step();
  }
  sim.end_stroke(0);
}

double lost(double deposited, double picked_up, double dried, double wet) {
  return deposited - picked_up - dried - wet;
}

double lost_medium_m3(const Simulation& sim) {
  const PaintAccount& account = sim.account();
  return lost(account.deposited.medium_m3, account.picked_up.medium_m3, account.dried.medium_m3,
              sim.wet().medium_m3);
}

double lost_pigment(const Simulation& sim) {
  const PaintAccount& account = sim.account();
  return lost(account.deposited.channel[0], account.picked_up.channel[0], account.dried.channel[0],
              sim.wet().channel[0]);
}

/// What half a quantum in each step, and in each plane, adds up to.
double most_lost(const Simulation& sim, float scale, int planes) {
  return static_cast<double>(conservative::quantum_for(scale)) / 2 * kSteps * planes *
         sim.geometry().cell_area_m2();
}

TEST(PaintAccount, IsOffByHalfAQuantumForEachStepAtMost) {
  const Threads threads(1);
  for (const float size_m : {1e-4f, 1e-3f, 1e-2f}) {
    for (const float paint_frac : {1e-4f, 1e-3f, 1e-2f, 0.5f}) {
      SCOPED_TRACE(testing::Message() << "size " << size_m << ", paint " << paint_frac);
      Simulation sim(coarse_canvas(), threads);
      BrushSettings settings;
      settings.size_m = size_m;
      settings.medium_frac = settings.pigment_frac = paint_frac;
      paint_line(sim, settings);
      sim.step();  // rounds what the last stamps left
      const PaintFlow& deposited = sim.account().deposited;
      EXPECT_GT(deposited.medium_m3, 0);
      EXPECT_LE(std::abs(lost_medium_m3(sim)), most_lost(sim, sim.model().max_medium_m, 1));
      EXPECT_LE(std::abs(lost_pigment(sim)),
                most_lost(sim, sim.model().max_pigment, sim.model().layers) +
                    kExchange * deposited.channel[0]);
    }
  }
}

TEST(PaintAccount, OfASpeckIsOffByAllOfItWhereNoStepLaysAQuantum) {
  const Threads threads(1);
  Simulation sim(coarse_canvas(), threads);
  BrushSettings settings;
  settings.size_m = 1e-4f;
  settings.medium_frac = settings.pigment_frac = 1e-4f;
  paint_line(sim, settings);
  sim.step();
  const double deposited_m3 = sim.account().deposited.medium_m3;
  const double step_m3 = deposited_m3 / kSteps;
  EXPECT_LT(step_m3, most_lost(sim, sim.model().max_medium_m, 1) / kSteps)
      << "a step lays less than half a quantum";
  EXPECT_EQ(sim.wet().medium_m3, 0) << "so nothing stays";
  EXPECT_GT(lost_medium_m3(sim), 0.9 * deposited_m3) << "but what the next stamps picked up";
}

TEST(PaintAccount, StepsWithoutABrushChangeNothing) {
  const Threads threads(1);
  Simulation sim(coarse_canvas(), threads);
  BrushSettings settings;
  settings.medium_frac = 1;
  settings.pigment_frac = 0.1f;  // it runs
  paint_line(sim, settings);
  sim.set_gravity({0, 9.8f, 1});
  sim.step();
  const double medium_m3 = lost_medium_m3(sim), pigment = lost_pigment(sim);
  for (int step = 0; step < 60; ++step) sim.step();
  EXPECT_EQ(lost_medium_m3(sim), medium_m3);
  EXPECT_EQ(lost_pigment(sim), pigment);
}

}  // namespace
}  // namespace pentimento
