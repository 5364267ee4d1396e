#include "formats/color/dither.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace pentimento {
namespace {

constexpr int kSide = 256;
constexpr double kPixels = double{kSide} * kSide;

struct Moments {
  double mean = 0, variance = 0;
};

/// Of the dithered codes of a flat area, less the value itself.
Moments error_of(int code16) {
  Moments m;
  const double value = static_cast<double>(code16) / kStepsPerCode;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const double e = dithered_code(code16, x, y, 0) - value;
      m.mean += e / kPixels;
      m.variance += e * e / kPixels;
    }
  return m;
}

TEST(Dither, TheMeanIsTheValueWhateverTheValue) {
  for (int code16 = 0; code16 <= 65535; code16 += 37) {
    // The error's deviation is at most sqrt(1/4) of a code: its mean over 65536 pixels deviates by
    // 0.002, and five of that never happen in 1772 values.
    ASSERT_NEAR(error_of(code16).mean, 0, 0.01) << code16;
  }
}

TEST(Dither, TheNoiseDoesNotDependOnTheValue) {
  // Triangular noise of +-1 code has variance 1/6, rounding adds 1/12: 1/4 in all, between the
  // ends.
  for (int code16 = 20000; code16 < 20000 + 2 * kStepsPerCode; code16 += 16)
    ASSERT_NEAR(error_of(code16).variance, 0.25, 0.01) << code16;
}

TEST(Dither, BlackAndWhiteStayClean) {
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      ASSERT_EQ(dithered_code(0, x, y, 0), 0);
      ASSERT_EQ(dithered_code(65535, x, y, 1), 255);
    }
}

TEST(Dither, CodesStayWithinACodeAndAHalf) {
  for (int code16 = 0; code16 <= 65535; ++code16) {
    const int code = dithered_code(code16, code16 % 101, code16 / 101, code16 % 3);
    ASSERT_GE(code, 0);
    ASSERT_LE(code, 255);
    // At most one code of noise and half a code of rounding.
    ASSERT_LE(std::abs(code - static_cast<double>(code16) / kStepsPerCode), 1.5);
  }
}

TEST(Dither, IsWeakAtLowFrequenciesAcross) {
  // The mean of 16 neighbours: independent noise would keep a sixteenth of the variance; of the
  // difference of neighbours only the two ends remain, 1/16 of that, and the rounding's 1/12 / 16.
  double variance = 0;
  constexpr int kCode16 = 100 * kStepsPerCode + 60;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; x += 16) {
      double mean = 0;
      for (int i = 0; i < 16; ++i)
        mean += (dithered_code(kCode16, x + i, y, 0) - kCode16 / 257.0) / 16;
      variance += mean * mean / (kPixels / 16);
    }
  EXPECT_LT(variance, 0.6 * 0.25 / 16);
}

TEST(Dither, ChannelsAreIndependent) {
  double product = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      product += (dither_uniform(x, y, 0) - 128.0) * (dither_uniform(x, y, 1) - 128.0) / kPixels;
  // In units of the variance, 257^2 / 12 = 5504: five deviations of the mean of 65536 products.
  EXPECT_NEAR(product / 5504, 0, 5.0 / kSide);
}

TEST(Dither, ARowIsDitheredAsItsPixelsAre) {
  for (const int x : {0, -3, 1, 40000})
    for (int channel = 0; channel < 3; ++channel)
      for (const int n : {1, 63, 64, 65, 700}) {
        // Codes of all sizes, and close to both ends, where the noise is another.
        std::vector<int> code, expected;
        for (int i = 0; i < n; ++i) {
          const int end = i % 300 < 150 ? 0 : 65535 - 300;
          code.push_back(i % 2 == 0 ? (i * 9973) % 65536 : end + i % 150);
          expected.push_back(dithered_code(code.back(), x + i, 12, channel));
        }
        dither_row(x, 12, channel, code);
        ASSERT_EQ(code, expected) << x << ' ' << channel << ' ' << n;
      }
}

}  // namespace
}  // namespace pentimento
