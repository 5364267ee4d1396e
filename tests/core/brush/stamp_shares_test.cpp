#include "core/brush/stamp_shares.h"

#include <gtest/gtest.h>

#include "core/brush/builtin_brushes.h"

namespace pentimento {
namespace {

// Shares are computed in double and kept as floats, whose steps are 6e-8 below 1.
constexpr float kFloat = 1e-7f;

/// A stamp that stands for `travel_m` of a tip 2 cm wide.
Stamp stamp_of(float travel_m, float pressure = -1) {
  Stamp stamp;
  stamp.diameter_m = 0.02f;
  stamp.travel_m = travel_m;
  stamp.pressure = pressure;
  return stamp;
}

TEST(StampShares, AShareOverAWayIsTheSameInOneStepAsInMany) {
  EXPECT_NEAR(share_over(0.3f, 1), 0.3f, kFloat);
  EXPECT_NEAR(share_over(0.3f, 2), 1 - 0.7f * 0.7f, kFloat);
  const float half = share_over(0.3f, 0.5);
  EXPECT_NEAR(1 - (1 - half) * (1 - half), 0.3f, 2 * kFloat);  // two factors, each rounded
  EXPECT_EQ(share_over(0.3f, 0), 0);
  EXPECT_EQ(share_over(1, 0.1), 1);
  EXPECT_EQ(share_over(-1, 5), 0);
}

TEST(StampShares, TheWayCountsInDiametersOfTheTipAsItIsPressed) {
  const BrushDefinition brush = *builtin_brush("round");
  const Stamp full = stamp_of(0.02f), light = stamp_of(0.02f, 0);
  EXPECT_NEAR(travelled_diameters(full, pose_of(full, brush, 0)), 1, 1e-7);
  EXPECT_NEAR(travelled_diameters(light, pose_of(light, brush, 0)),
              1 / (1 - static_cast<double>(brush.size_pressure)), 1e-6);
}

TEST(StampShares, ABrushLiftsTheSlidersShareOfADiameterWhateverItsPressure) {
  const BrushDefinition brush = *builtin_brush("round");
  BrushSettings settings;
  settings.pickup = 0.4f;
  const Stamp full = stamp_of(0.02f);
  EXPECT_NEAR(pickup_share(full, brush, settings, pose_of(full, brush, 0)), 0.4f, kFloat);
  Stamp light = stamp_of(0.02f, 0.1f);
  const TipPose pose = pose_of(full, brush, 0);
  EXPECT_NEAR(pickup_share(light, brush, settings, pose), 0.4f, kFloat);
}

TEST(StampShares, ARagSoaksUpByItsOwnShareAndLessWhenItOnlyLies) {
  BrushDefinition rag = *builtin_brush("round");
  rag.film = 0;
  rag.absorb = 0.9f;
  BrushSettings settings;
  settings.pickup = 0.3f;
  const Stamp pressed = stamp_of(0.02f, 1);
  const TipPose pose = pose_of(pressed, rag, 0);
  EXPECT_NEAR(pickup_share(pressed, rag, settings, pose), 0.9f, kFloat);
  // 0.3 of the way: 1 - 0.1^0.3.
  EXPECT_NEAR(pickup_share(stamp_of(0.02f, 0), rag, settings, pose), 0.498813f, 1e-6f);
  settings.pickup = 0.95f;
  EXPECT_NEAR(pickup_share(pressed, rag, settings, pose), 0.95f, kFloat);
}

TEST(StampShares, ThePaletteReplacesItsShareEveryTenthOfADiameter) {
  BrushDefinition brush = *builtin_brush("round");
  BrushSettings settings;
  settings.refill = 0.05f;
  const Stamp tenth = stamp_of(0.002f);
  const TipPose pose = pose_of(tenth, brush, 0);
  EXPECT_NEAR(refill_share(tenth, brush, settings, pose), 0.05f, kFloat);
  // 1 - 0.95^10; the tenth of the diameter is a float.
  EXPECT_NEAR(refill_share(stamp_of(0.02f), brush, settings, pose), 0.401263f, 1e-6f);
  brush.film = 0;  // a knife is not dipped
  EXPECT_EQ(refill_share(tenth, brush, settings, pose), 0);
}

TEST(StampShares, LayersMixByHalfAtMostAndByPressure) {
  const BrushDefinition brush = *builtin_brush("round");
  BrushSettings settings;
  settings.layer_mixing = 0.3f;
  const Stamp full = stamp_of(0.02f, 1);
  const TipPose pose = pose_of(full, brush, 0);
  EXPECT_NEAR(mixing_share(full, settings, pose), 0.15f, kFloat);
  EXPECT_NEAR(mixing_share(stamp_of(0.02f, 0.5f), settings, pose), 0.075f, kFloat);
  settings.layer_mixing = 1;
  EXPECT_EQ(mixing_share(full, settings, pose), 0.5f);
}

TEST(StampShares, WhatABrushHoldsTooMuchGoesBackOverADiameterButNotFromARag) {
  BrushDefinition brush = *builtin_brush("round");
  const Stamp stamp = stamp_of(0.02f);
  const TipPose pose = pose_of(stamp, brush, 0);
  EXPECT_NEAR(return_share(stamp, brush, pose), 0.632121f, 1e-6f);  // 1 - 1/e
  brush.absorb = 1;
  EXPECT_EQ(return_share(stamp, brush, pose), 0);
}

TEST(StampShares, ABladeTakesNearlyAllWithinItsThickness) {
  const BrushDefinition brush = *builtin_brush("round");
  const Stamp stamp = stamp_of(0.14f * 0.02f);
  const TipPose pose = pose_of(stamp, brush, 0);
  EXPECT_NEAR(scraped_share(stamp, pose), 0.97f, 1e-6f);  // the thickness is a float
  EXPECT_NEAR(scraped_share(stamp_of(0.28f * 0.02f), pose), 1 - 0.03f * 0.03f, 1e-6f);
}

}  // namespace
}  // namespace pentimento
