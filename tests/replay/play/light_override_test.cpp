#include "replay/play/light_override.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

Lighting with(const LightChoice& choice, Lighting lighting = {}) {
  const auto made = LightOverride::make(choice);
  EXPECT_TRUE(made) << made.error().message;
  made->apply(lighting);
  return lighting;
}

TEST(LightOverride, NothingChosenChangesNothing) {
  Lighting log;
  log.lamps[0].follows_gravity = true;
  log.lamps[0].position_m = {1, 2, 3};
  log.exposure_ev = 2;
  log.probe[0] = Field<float>(4, 2);
  const std::vector<Lamp> lamps = log.lamps;
  const Lighting same = with({}, std::move(log));
  EXPECT_EQ(same.lamps, lamps);
  EXPECT_EQ(same.exposure_ev, 2);
  EXPECT_FALSE(same.probe[0].empty());
}

TEST(LightOverride, ADirectionMovesTheFirstLampAndHoldsItThere) {
  Lighting log;
  log.lamps.resize(2);
  log.lamps[0].position_m = {1, 2, 3};
  log.lamps[0].follows_gravity = true;
  log.lamps[0].intensity = 0.3f;
  LightChoice choice;
  choice.direction = {0, 3, 4};
  const Lighting lit = with(choice, std::move(log));
  EXPECT_EQ(lit.lamps[0].direction, (std::array<float, 3>{0, 0.6f, 0.8f}));
  EXPECT_FALSE(lit.lamps[0].position_m);
  EXPECT_FALSE(lit.lamps[0].follows_gravity);
  EXPECT_EQ(lit.lamps[0].intensity, 0.3f);
  EXPECT_EQ(lit.lamps[1], Lamp{});
}

TEST(LightOverride, LampsStandInPlaceOfAllOthers) {
  Lighting log;
  log.lamps.resize(3);
  LightChoice choice;
  choice.lamps.resize(2);
  choice.lamps[1].intensity = 0.2f;
  choice.intensity = 0.6;
  choice.follow_gravity = true;
  const Lighting lit = with(choice, std::move(log));
  ASSERT_EQ(lit.lamps.size(), 2u);
  EXPECT_EQ(lit.lamps[0].intensity, 0.6f);
  EXPECT_TRUE(lit.lamps[0].follows_gravity);
  EXPECT_EQ(lit.lamps[1].intensity, 0.2f);
  EXPECT_FALSE(lit.lamps[1].follows_gravity);
}

TEST(LightOverride, ASoftEnvironmentHasNoProbe) {
  Lighting log;
  for (Field<float>& plane : log.probe) plane = Field<float>(4, 2);
  LightChoice choice;
  choice.soft_environment = true;
  EXPECT_TRUE(with(choice, std::move(log)).probe[0].empty());
}

}  // namespace
}  // namespace pentimento
