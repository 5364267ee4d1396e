#include "core/optics/tone.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

TEST(Tone, CurvesNeverFallAndNeverPassOne) {
  for (const ToneCurve curve : {ToneCurve::kSoft, ToneCurve::kFilmic}) {
    float before = 0;
    for (int i = 0; i <= 4000; ++i) {
      const float y = tone(curve, static_cast<float>(i) * 0.005f);
      EXPECT_GE(y, before);
      EXPECT_LE(y, 1);
      before = y;
    }
    EXPECT_GT(before, 0.95f);
  }
}

TEST(Tone, SoftLeavesTheLowerPartAloneAndBendsWithoutAKink) {
  EXPECT_EQ(tone(ToneCurve::kSoft, 0.5f), 0.5f);
  EXPECT_EQ(tone(ToneCurve::kNone, 7.0f), 7.0f);
  const float slope = (tone(ToneCurve::kSoft, 0.71f) - tone(ToneCurve::kSoft, 0.70f)) / 0.01f;
  EXPECT_NEAR(slope, 1, 0.05f);  // 1 - 2 x 0.005 / 0.3 over this step
}

TEST(Tone, HasTheHeaderFormulasValues) {
  // By hand: the knee, and 1 - 0.3 / (1 + n) at n times 0.3 above it.
  EXPECT_EQ(tone(ToneCurve::kSoft, 0.7f), 0.7f);
  EXPECT_FLOAT_EQ(tone(ToneCurve::kSoft, 0.72f), 0.71875f);  // 1 - 0.3 / (1 + 1/15)
  EXPECT_FLOAT_EQ(tone(ToneCurve::kSoft, 1.0f), 0.85f);
  EXPECT_FLOAT_EQ(tone(ToneCurve::kSoft, 1.3f), 0.9f);
  EXPECT_FLOAT_EQ(tone(ToneCurve::kFilmic, 0.5f), 0.6425f / 1.0425f);
}

TEST(Tone, NamesLeadBack) {
  for (const ToneCurve curve : {ToneCurve::kNone, ToneCurve::kSoft, ToneCurve::kFilmic})
    EXPECT_EQ(tone_curve_of(tone_curve_name(curve)), curve);
  EXPECT_FALSE(tone_curve_of("hard"));
}

TEST(WhiteBalance, MakesItsWhiteNeutralAndLeavesD65Alone) {
  const auto same = white_balance(kD65_xy);
  EXPECT_EQ(same[0], (std::array<float, 3>{1, 0, 0}));
  // CIE illuminant A, XYZ (1.0985, 1, 0.3558), times the sRGB standard's matrix by hand.
  const std::array<float, 3> warm = {1.8452f, 0.8263f, 0.2333f};
  const auto matrix = white_balance({0.44758f, 0.40745f});
  for (const auto& row : matrix) {
    const float v = row[0] * warm[0] + row[1] * warm[1] + row[2] * warm[2];
    EXPECT_NEAR(v, 1, 0.02f);  // D65's xy to four digits, warm's RGB to three
  }
}

TEST(WhiteBalance, TemperaturesLieWhereTheyAreTabulated) {
  const auto daylight = white_of_temperature(6504), lamp = white_of_temperature(2856);
  EXPECT_NEAR(daylight[0], 0.3127f, 5e-4f);  // D65
  EXPECT_NEAR(daylight[1], 0.3290f, 5e-4f);
  EXPECT_NEAR(lamp[0], 0.4476f, 2e-3f);  // illuminant A; the fit's stated error
  EXPECT_NEAR(lamp[1], 0.4074f, 2e-3f);
}

}  // namespace
}  // namespace pentimento
