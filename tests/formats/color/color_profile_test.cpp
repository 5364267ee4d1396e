#include "formats/color/color_profile.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pentimento {
namespace {

TEST(ColorProfile, TheSrgbCurveIsTheStandards) {
  for (int i = 1; i <= 1000; ++i) {
    const double v = i / 1000.0;
    const double light = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    const double code = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
    for (const ColorProfile profile : {ColorProfile::kSrgb, ColorProfile::kDisplayP3}) {
      // Both sides are good to a few units of double precision.
      EXPECT_NEAR(decode_transfer(profile, v) / light, 1, 1e-14) << v;
      EXPECT_NEAR(encode_transfer(profile, v) / code, 1, 1e-14) << v;
    }
  }
}

TEST(ColorProfile, TheAdobeCurveIsAPowerOf563Over256) {
  for (int i = 1; i <= 1000; ++i) {
    const double v = i / 1000.0;
    // As above.
    EXPECT_NEAR(decode_transfer(ColorProfile::kAdobeRgb, v) / std::pow(v, 2.19921875), 1, 1e-14);
    EXPECT_NEAR(encode_transfer(ColorProfile::kAdobeRgb, v) / std::pow(v, 1 / 2.19921875), 1,
                1e-14);
  }
}

TEST(ColorProfile, BlackAndWhiteAreExact) {
  for (const ColorProfile profile : kColorProfiles) {
    EXPECT_EQ(decode_transfer(profile, 0), 0);
    EXPECT_EQ(decode_transfer(profile, 1), 1);
    EXPECT_EQ(encode_transfer(profile, 0), 0);
    EXPECT_DOUBLE_EQ(encode_transfer(profile, 1), 1);
  }
}

void expect_matrix(const ColorMatrix& m, const ColorMatrix& published, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_NEAR(m[i][j], published[i][j], tolerance) << i << "," << j;
}

TEST(ColorProfile, MatricesToXyzAreThePublishedOnes) {
  // IEC 61966-2-1 and Adobe RGB (1998), 4.3.5.3, print four and five digits; the first is computed
  // from a D65 of four digits as here, the second too, and both round the matrix.
  expect_matrix(to_xyz(ColorProfile::kSrgb),
                {{{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}},
                1.1e-4);
  expect_matrix(
      to_xyz(ColorProfile::kAdobeRgb),
      {{{0.57667, 0.18556, 0.18823}, {0.29734, 0.62736, 0.07529}, {0.02703, 0.07069, 0.99134}}},
      1e-5);
  // SMPTE EG 432-1 leaves it to be computed; CSS Color 4 prints these.
  expect_matrix(to_xyz(ColorProfile::kDisplayP3),
                {{{0.48657, 0.26567, 0.19822}, {0.22897, 0.69174, 0.07929}, {0, 0.04511, 1.04394}}},
                1e-5);
}

TEST(ColorProfile, WhiteStaysWhiteAndTheWayBackLeadsBack) {
  for (const ColorProfile a : kColorProfiles)
    for (const ColorProfile b : kColorProfiles) {
      const ColorMatrix there = between(a, b), back = between(b, a);
      for (std::size_t i = 0; i < 3; ++i) {
        // Rounding of two inversions.
        EXPECT_NEAR(there[i][0] + there[i][1] + there[i][2], 1, 1e-14);
        for (std::size_t j = 0; j < 3; ++j) {
          double sum = 0;
          for (std::size_t k = 0; k < 3; ++k) sum += there[i][k] * back[k][j];
          EXPECT_NEAR(sum, i == j ? 1 : 0, 1e-14);
        }
      }
    }
}

TEST(ColorProfile, NamesAndPrimariesLeadBack) {
  for (const ColorProfile profile : kColorProfiles) {
    EXPECT_EQ(profile_named(profile_name(profile)), profile);
    EXPECT_EQ(profile_with(primaries_of(profile), kWhiteD65), profile);
  }
  EXPECT_FALSE(profile_named("cmyk"));
  EXPECT_FALSE(profile_with(primaries_of(ColorProfile::kSrgb), {0.3457, 0.3585}));  // D50
}

}  // namespace
}  // namespace pentimento
