// A canvas that is dumped to a file and read goes on as if nothing had happened.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

#include "core/fluid/conservative/tiles/sleep_tiles.h"
#include "core/simulation/simulation.h"
#include "formats/hdf5/state_dump.h"
#include "replay/play/copies.h"
#include "replay/play/lighting_track.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

const Threads kThreads(1);
constexpr Vec3f kTilt{1, -6, 7};

std::vector<Pigment> one_pigment() {
  return {{"ochre", Eigen::Vector3d(0.2, 0.4, 1.1), Eigen::Vector3d(0.5, 0.3, 0.1)}};
}

/// 96 x 72 cells of 0.6 x 0.45 m: 12 x 9 tiles.
std::unique_ptr<Simulation> simulation(const Model& model, CanvasState state) {
  SimulationSetup setup;
  setup.geometry = state.geometry;
  setup.model = model;
  setup.basis = make_channels(one_pigment());
  auto made = std::make_unique<Simulation>(std::move(setup), kThreads);
  made->restore(std::move(state));
  made->set_gravity(kTilt);
  return made;
}

/// Two patches of runny paint, thick and thin, far from each other.
CanvasState thin_paint(const Model& model) {
  CanvasState state = make_canvas_state({96, 72, 0.6, 0.45}, model.layers, 1, 3, 0.9f);
  for (int y = 10; y < 26; ++y) {
    for (int x = 12; x < 30; ++x) {
      state.depth_m(x, y) = 0.0021f + 1e-5f * static_cast<float>(x * y % 7);
      state.channel(0, 0)(x, y) = 0.013f;
      state.channel(1, 0)(x, y) = 0.007f;
      state.depth_m(x + 50, y + 30) = 1e-4f;
      state.channel(0, 0)(x + 50, y + 30) = 0.01f;
    }
  }
  return state;
}

CanvasState through_a_file(const Simulation& from) {
  const test::Scratch scratch;
  StateDump dump;
  dump.state = clone_state(from.state());
  dump.model = from.model();
  dump.palette = one_pigment();
  dump.basis = from.basis();
  dump.lighting = default_lighting();
  EXPECT_TRUE(write_state(scratch.path("a.h5"), dump, {}).ok());
  Result<StateDump> back = read_state(scratch.path("a.h5"));
  EXPECT_TRUE(back.ok());
  EXPECT_EQ(back->state_sha256, state_sha256(from.state()));
  return std::move(back->state);
}

void step(Simulation& s, int steps) {
  for (int i = 0; i < steps; ++i) s.step();
}

class Continue : public testing::TestWithParam<SchemeKind> {};
INSTANTIATE_TEST_SUITE_P(Schemes, Continue,
                         testing::Values(SchemeKind::kPaper, SchemeKind::kConservative));

TEST_P(Continue, APaintingThatFlowsGoesOnBitForBit) {
  Model model;
  model.scheme = GetParam();
  // Cut before the first step, after odd and even numbers of steps, and late in the flow.
  for (const int before : {0, 1, 6, 37}) {
    const auto whole = simulation(model, thin_paint(model));
    step(*whole, before);
    const auto rest = simulation(model, through_a_file(*whole));
    step(*whole, 30);
    step(*rest, 30);
    EXPECT_EQ(state_sha256(rest->state()), state_sha256(whole->state())) << before;
  }
}

TEST_P(Continue, APaintingThatIsMovedAgainGoesOnBitForBit) {
  Model model;
  model.scheme = GetParam();
  const auto whole = simulation(model, thin_paint(model));
  step(*whole, 20);
  const auto rest = simulation(model, through_a_file(*whole));
  for (Simulation* s : {whole.get(), rest.get()}) {
    s->set_gravity({-6, 1, 7});
    step(*s, 20);
    s->dry();
    step(*s, 3);
  }
  EXPECT_EQ(state_sha256(rest->state()), state_sha256(whole->state()));
}

TEST(ContinueAsleep, WhatSleptSleepsOnAndTheRestFlowsOn) {
  const Model model;  // conservative
  const auto whole = simulation(model, thin_paint(model));
  step(*whole, 12);
  const std::vector<float>& sleep = whole->state().sleep;
  int asleep = 0;
  for (std::size_t i = 0; i < sleep.size(); i += conservative::kSleepValues)
    asleep += sleep[i + conservative::kAsleep] != 0 ? 1 : 0;
  // Otherwise this test would say nothing.
  ASSERT_GT(asleep, 0);
  ASSERT_LT(asleep, 12 * 9);
  CanvasState state = through_a_file(*whole);
  EXPECT_EQ(state.sleep, sleep);
  const auto rest = simulation(model, std::move(state));
  step(*whole, 1);
  step(*rest, 1);
  EXPECT_EQ(rest->state().sleep, whole->state().sleep);
  EXPECT_EQ(state_sha256(rest->state()), state_sha256(whole->state()));
}

}  // namespace
}  // namespace pentimento
