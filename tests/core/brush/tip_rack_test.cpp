#include "core/brush/tip_rack.h"

#include <gtest/gtest.h>

#include <thread>

#include "core/brush/builtin_brushes.h"
#include "core/optics/paints/pigment_library.h"
#include "core/simulation/simulation.h"

namespace pentimento {
namespace {

BrushDefinition textured(float value) {
  BrushDefinition brush;
  brush.name = "leaf";
  brush.shape = TipShape::kTexture;
  brush.texture = Field<float>(2, 2);
  brush.texture.fill(value);
  return brush;
}

TEST(TipRack, DrawsATipOnce) {
  TipRack rack;
  const auto tip = rack.find(*builtin_brush("flat"));
  EXPECT_EQ(rack.find(*builtin_brush("flat")), tip);
  EXPECT_NE(rack.find(*builtin_brush("round")), tip);
}

// Logs of different people share a rack: the name alone does not say what a brush is.
TEST(TipRack, BrushesOfOneNameMayDiffer) {
  TipRack rack;
  const auto strong = rack.find(textured(1)), weak = rack.find(textured(0.5f));
  EXPECT_NE(strong, weak);
  EXPECT_GT(strong->mean(), weak->mean());
  EXPECT_EQ(rack.find(textured(1)), strong);
  BrushDefinition other = *builtin_brush("flat");
  const auto flat = rack.find(other);
  other.grip = 0.5f;
  EXPECT_NE(rack.find(other), flat);
  other = *builtin_brush("flat");
  ++other.bristles.count;
  EXPECT_NE(rack.find(other), flat);
}

TEST(TipRack, ThreadsGetTheSameTip) {
  TipRack rack;
  std::shared_ptr<const Tip> other;
  std::thread thread([&] { other = rack.find(textured(1)); });
  const auto mine = rack.find(textured(1));
  thread.join();
  EXPECT_EQ(mine, other);
}

/// A simulation that has stamped with the round brush.
std::unique_ptr<Simulation> stamped(const std::shared_ptr<TipRack>& rack, const Threads& threads) {
  SimulationSetup setup;
  setup.geometry = {16, 16, 0.16, 0.16};
  setup.basis = palette_channels({*find_library_pigment("Vermilion")});
  setup.paper_m = Field<float>(16, 16);
  setup.tips = rack;
  auto simulation = std::make_unique<Simulation>(std::move(setup), threads);
  Stamp stamp;
  stamp.x_m = stamp.y_m = 0.08;
  stamp.diameter_m = 0.05f;
  simulation->begin_stroke(0, 1);
  simulation->stamp(0, stamp);
  return simulation;
}

TEST(TipRack, SimulationsThatShareItDrawTheTipOnce) {
  const Threads threads(1);
  const auto rack = std::make_shared<TipRack>();
  const auto first = stamped(rack, threads), second = stamped(rack, threads);
  const auto fork = second->fork(threads);
  // The rack, three brushes in hands, and this pointer.
  EXPECT_EQ(rack->find(*builtin_brush("round")).use_count(), 5);
}

}  // namespace
}  // namespace pentimento
