#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "core/brush/builtin_brushes.h"
#include "tests/core/simulation/strokes.h"

namespace pentimento {
namespace {

using namespace test;

/// Two strokes that mix, by a wet and drying brush. `expect` is told the number of each stamp and
/// may say which it expects after it.
CanvasState paint_expecting(const Threads& threads, const std::string& brush,
                            const std::function<void(Simulation&, std::size_t)>& expect) {
  Simulation sim(setup_of(128, 2), threads);
  sim.set_brush(*builtin_brush(brush));
  for (const StrokePlan& stroke :
       {StrokePlan{{at(0.03, 0.03, 0, 0.3f), at(0.1, 0.08, 0.3, 1), at(0.17, 0.1, 0.6)}, 0, 1, 0},
        StrokePlan{{at(0.03, 0.1, 1), at(0.1, 0.07, 1.3, 0.5f), at(0.17, 0.03, 1.6)}, 1, 2, 0}}) {
    sim.set_color(stroke.pigment);
    sim.begin_stroke(0, stroke.id);
    const std::vector<Stamp> stamps = stamps_of(stroke.samples);
    for (std::size_t i = 0; i < stamps.size(); ++i) {
      expect(sim, i);
      sim.stamp(0, stamps[i]);
      if (i % 7 == 6) sim.step();
    }
    sim.end_stroke(0);
  }
  return clone_state(sim.state());
}

TEST(ExpectedStamps, WhatIsExpectedChangesNothing) {
  const Threads one(1), two(2);
  const auto nothing = [](Simulation&, std::size_t) {};
  const std::vector<Stamp> first =
      stamps_of({at(0.03, 0.03, 0, 0.3f), at(0.1, 0.08, 0.3, 1), at(0.17, 0.1, 0.6)});
  for (const char* brush : {"round", "bristle", "knife"}) {
    const CanvasState plain = paint_expecting(one, brush, nothing);
    // Right in the first stroke, wrong in the second; always the same; of another touch.
    const auto right = [&](Simulation& sim, std::size_t i) {
      if (i + 1 < first.size()) sim.expect(0, first[i + 1]);
    };
    const auto same = [&](Simulation& sim, std::size_t) { sim.expect(0, first[0]); };
    const auto anothers = [&](Simulation& sim, std::size_t i) {
      if (i + 1 < first.size()) sim.expect(3, first[i + 1]);
    };
    expect_same_bits(plain, paint_expecting(two, brush, nothing));
    expect_same_bits(plain, paint_expecting(two, brush, right));
    expect_same_bits(plain, paint_expecting(one, brush, right));
    expect_same_bits(plain, paint_expecting(two, brush, same));
    expect_same_bits(plain, paint_expecting(two, brush, anothers));
  }
}

TEST(ExpectedStamps, AnotherBrushDoesNotLayTheTipThatWasDrawnForTheOneBefore) {
  const Threads one(1), two(2);
  const std::vector<Stamp> stamps =
      stamps_of({at(0.05, 0.05, 0, 0.4f), at(0.1, 0.08, 0.3, 0.4f), at(0.15, 0.09, 0.6, 0.4f)});
  // The other brush has the same tip, and is smaller at this pressure.
  const auto paint_two = [&](const Threads& threads) {
    Simulation sim(setup_of(128, 2), threads);
    BrushDefinition brush = builtin_brush("round")->clone();
    sim.set_brush(brush);
    sim.begin_stroke(0, 1);
    for (std::size_t i = 0; i + 1 < stamps.size(); ++i) {
      sim.expect(0, stamps[i + 1]);
      sim.stamp(0, stamps[i]);
      if (i != stamps.size() / 2) continue;
      brush.size_pressure = 1;
      sim.set_brush(brush);
    }
    return clone_state(sim.state());
  };
  expect_same_bits(paint_two(one), paint_two(two));
}

}  // namespace
}  // namespace pentimento
