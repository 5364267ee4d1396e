#include "formats/color/gamut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pentimento {
namespace {

constexpr LinearRgb kRec709 = {0.2126f, 0.7152f, 0.0722f};

double luminance(const LinearRgb& c) {
  double y = 0;
  for (std::size_t i = 0; i < 3; ++i)
    y += static_cast<double>(kRec709[i]) * static_cast<double>(c[i]);
  return y;
}

/// A colour without what makes it too bright: what is left goes through the plain projection.
LinearRgb darkened(LinearRgb c) {
  const double brightest = static_cast<double>(std::max({c[0], c[1], c[2]}));
  if (brightest > 1)
    for (float& v : c) v = static_cast<float>(static_cast<double>(v) * std::pow(brightest, -0.75));
  return c;
}

/// A grid of colours from -0.6 to 1.6 in each of the three.
template <typename Do>
void for_colours(const Do& visit) {
  for (int r = -6; r <= 16; ++r)
    for (int g = -6; g <= 16; ++g)
      for (int b = -6; b <= 16; ++b)
        visit(LinearRgb{static_cast<float>(r) / 10, static_cast<float>(g) / 10,
                        static_cast<float>(b) / 10});
}

TEST(Gamut, KeepsWhatIsInside) {
  for_colours([](const LinearRgb& c) {
    if (std::min({c[0], c[1], c[2]}) >= 0 && std::max({c[0], c[1], c[2]}) <= 1) {
      EXPECT_EQ(into_gamut(c, kRec709), c);
    }
  });
}

TEST(Gamut, KeepsLuminanceButForWhatIsTooBright) {
  for_colours([](const LinearRgb& c) {
    const LinearRgb out = into_gamut(c, kRec709);
    for (const float v : out) {
      ASSERT_GE(v, 0);
      ASSERT_LE(v, 1);
    }
    // A few roundings of single precision.
    ASSERT_NEAR(luminance(out), std::clamp(luminance(darkened(c)), 0.0, 1.0), 1e-6);
  });
}

TEST(Gamut, KeepsHueAndTakesNoMoreSaturationThanItMust) {
  for_colours([](const LinearRgb& asked) {
    const LinearRgb c = darkened(asked);
    const double y = luminance(c);
    if (y <= 0.01 || y >= 0.99) return;
    const LinearRgb out = into_gamut(asked, kRec709);
    // Differences to the neutral keep their ratios: one factor t for all three.
    double cross = 0, dot = 0, own = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const double a = static_cast<double>(c[i]) - y, b = static_cast<double>(c[j]) - y;
      const double p = static_cast<double>(out[i]) - y, q = static_cast<double>(out[j]) - y;
      cross = std::max(cross, std::abs(a * q - b * p));
      dot += a * p;
      own += a * a;
    }
    ASSERT_LT(cross, 1e-5);  // single precision
    if (own > 0) {
      ASSERT_GE(dot / own, 0);
    }
    if (out != asked) {
      // It lies on the gamut's surface.
      const float low = std::min({out[0], out[1], out[2]});
      const float high = std::max({out[0], out[1], out[2]});
      ASSERT_TRUE(low < 1e-6f || high > 1 - 1e-6f);
    }
  });
}

TEST(Gamut, ByHand) {
  // 1.2^(-3/4) = 0.87220: (1.04664, 0.26166, 0.26166). Y = 0.42855; t = (1 - Y) / (1.04664 - Y).
  const LinearRgb highlight = into_gamut({1.2f, 0.3f, 0.3f}, kRec709);
  EXPECT_NEAR(highlight[0], 1, 1e-6);
  EXPECT_NEAR(highlight[1], 0.27425, 2e-5);
  EXPECT_NEAR(highlight[2], 0.27425, 2e-5);
  // A yellow whose luminance is above white's: (1.06159, 0.89441, 0), Y = 0.86536; t = 0.68618.
  const LinearRgb yellow = into_gamut({1.27f, 1.07f, 0}, kRec709);
  EXPECT_NEAR(yellow[0], 1, 1e-6);
  EXPECT_NEAR(yellow[1], 0.88529, 2e-5);
  EXPECT_NEAR(yellow[2], 0.27157, 2e-5);
  // A green beyond Rec. 709: Y = -0.04252 + 0.35760 + 0.00722 = 0.32230; t = Y / (Y + 0.2).
  const LinearRgb green = into_gamut({-0.2f, 0.5f, 0.1f}, kRec709);
  EXPECT_NEAR(green[0], 0, 1e-6);
  EXPECT_NEAR(green[1], 0.43195, 1e-5);
  EXPECT_NEAR(green[2], 0.18512, 1e-5);
}

TEST(Gamut, IsContinuousAtTheSurface) {
  const LinearRgb inside = {1, 0.25f, 0}, outside = {1.0001f, 0.25f, -0.0001f};
  const LinearRgb out = into_gamut(outside, kRec709);
  // A step of 1e-4 outwards moves the result by as much, times the slope of the surface.
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(out[i], inside[i], 5e-4);
}

TEST(Gamut, BeyondWhiteIsWhiteAndBelowBlackIsBlack) {
  const LinearRgb white = {1, 1, 1}, black = {0, 0, 0};
  EXPECT_EQ(into_gamut({3, 3, 2.5f}, kRec709), white);
  EXPECT_EQ(into_gamut({INFINITY, INFINITY, INFINITY}, kRec709), white);
  EXPECT_EQ(into_gamut({0.1f, INFINITY, 0.1f}, kRec709), white);
  EXPECT_EQ(into_gamut({-0.1f, -0.2f, 0.1f}, kRec709), black);
}

}  // namespace
}  // namespace pentimento
