#include "core/brush/held_brush.h"

#include <gtest/gtest.h>

#include "core/brush/builtin_brushes.h"
#include "tests/core/three_pigments.h"

namespace pentimento {
namespace {

class HeldBrushTest : public testing::Test {
 protected:
  ChannelBasis basis_ = palette_channels(test::three_pigments());
  Model model_;
  HeldBrush held_{basis_, model_};
};

TEST_F(HeldBrushTest, IsRoundAndDippedIntoTheFirstPigment) {
  EXPECT_EQ(held_.brush().name, "round");
  ASSERT_EQ(held_.colors().size(), 1u);
  EXPECT_EQ(held_.colors()[0].pigment, 0);
  // Two films: of 2 mm with all the medium, of which it has half; of 0.04 with all the pigment.
  const std::vector<float>& paint = held_.load().paint;
  EXPECT_FLOAT_EQ(paint[0], 2 * 0.002f * 0.5f);
  EXPECT_FLOAT_EQ(paint[1], 2 * 0.04f * 0.7f);
  EXPECT_EQ(paint[2], 0);
  EXPECT_EQ(paint[3], 0);
}

TEST_F(HeldBrushTest, AnotherBrushIsCleanTheSameIsNot) {
  EXPECT_FALSE(held_.take(*builtin_brush("round")));
  EXPECT_TRUE(held_.take(*builtin_brush("flat")));
  EXPECT_EQ(held_.brush().name, "flat");
  EXPECT_FALSE(held_.take(*builtin_brush("flat")));
}

TEST_F(HeldBrushTest, HasTheTipOfTheBrushInTheHand) {
  const Tip* round = &held_.tip();
  EXPECT_FALSE(held_.take(*builtin_brush("round")));
  EXPECT_EQ(&held_.tip(), round);
  EXPECT_TRUE(held_.take(*builtin_brush("flat")));
  EXPECT_NE(&held_.tip(), round);
  HeldBrush other(basis_, model_);
  other.become(held_);
  EXPECT_EQ(&other.tip(), &held_.tip()) << "drawn once";
}

TEST_F(HeldBrushTest, WhoBecameAnotherDrawsNoTipAgain) {
  HeldBrush other(basis_, model_), third(basis_, model_);
  other.become(held_);
  third.become(other);
  EXPECT_EQ(&third.tip(), &held_.tip()) << "neither had drawn it then";
  HeldBrush stranger(basis_, model_);
  EXPECT_NE(&stranger.tip(), &held_.tip());
}

TEST_F(HeldBrushTest, OnlySlidersOfThePaintLoadItAfresh) {
  BrushSettings settings;
  settings.pickup = 0.9f;
  settings.size_m = 0.01f;
  EXPECT_FALSE(held_.set_settings(settings));
  EXPECT_EQ(held_.settings().pickup, 0.9f);
  settings.medium_frac = 0.1f;
  EXPECT_TRUE(held_.set_settings(settings));
  settings.pigment_frac = 0.1f;
  EXPECT_TRUE(held_.set_settings(settings));
  EXPECT_FLOAT_EQ(held_.load().paint[1], 2 * 0.04f * 0.1f);
}

TEST_F(HeldBrushTest, FollowsTheModelsFilm) {
  EXPECT_FALSE(held_.reload());
  model_.film_pigment = 0.02f;
  EXPECT_TRUE(held_.reload());
  EXPECT_FLOAT_EQ(held_.load().paint[1], 2 * 0.02f * 0.7f);
  model_.brush_push = 0.6f;
  EXPECT_FALSE(held_.reload());
}

TEST_F(HeldBrushTest, ColoursLieSideBySideTheLaterOverTheEarlier) {
  held_.set_color(1);
  const ReservoirRows half = held_.set_color(2, 0.5f, 1);
  EXPECT_EQ(half.begin, kReservoirRows / 2);
  EXPECT_EQ(half.end, kReservoirRows);
  ASSERT_EQ(held_.colors().size(), 2u);
  EXPECT_GT(held_.load().row(kReservoirRows / 2 - 1)[2], 0);
  EXPECT_EQ(held_.load().row(kReservoirRows / 2)[2], 0);
  EXPECT_GT(held_.load().row(kReservoirRows / 2)[3], 0);
  held_.set_color(1);
  EXPECT_EQ(held_.colors().size(), 1u);
  EXPECT_GT(held_.load().row(kReservoirRows - 1)[2], 0);
}

TEST(ReservoirRows, APartOfTheWidthHasARowAtLeast) {
  EXPECT_EQ(rows_across(0, 1).begin, 0);
  EXPECT_EQ(rows_across(0, 1).end, kReservoirRows);
  const ReservoirRows none = rows_across(0.25f, 0.25f), last = rows_across(1, 1);
  EXPECT_EQ(none.begin, kReservoirRows / 4);
  EXPECT_EQ(none.end, kReservoirRows / 4 + 1);
  EXPECT_EQ(last.begin, kReservoirRows - 1);
  EXPECT_EQ(last.end, kReservoirRows);
}

}  // namespace
}  // namespace pentimento
