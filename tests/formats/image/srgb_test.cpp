#include "formats/image/srgb.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pentimento {
namespace {

TEST(Srgb, IsTheStandardsCurve) {
  for (int i = 1; i <= 1000; ++i) {
    const double v = i / 1000.0;
    const double light = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    const double code = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
    // Both sides are good to a few units of double precision.
    EXPECT_NEAR(srgb_to_linear(v) / light, 1, 1e-14) << v;
    EXPECT_NEAR(linear_to_srgb(v) / code, 1, 1e-14) << v;
  }
  EXPECT_EQ(srgb_to_linear(0), 0);
  EXPECT_EQ(srgb_to_linear(1), 1);
  EXPECT_DOUBLE_EQ(linear_to_srgb(1), 1);
}

TEST(Srgb, EveryCodeComesBack) {
  for (const int max : {255, 65535}) {
    const SrgbEncoder encoder(max);
    for (int c = 0; c <= max; ++c)
      ASSERT_EQ(encoder.encode(static_cast<float>(srgb_to_linear(static_cast<double>(c) / max))),
                c);
  }
}

TEST(Srgb, RoundsAtTheMiddleBetweenCodes) {
  const SrgbEncoder encoder(255);
  for (int c = 0; c < 255; ++c) {
    const double edge = srgb_to_linear((c + 0.5) / 255);
    // The nearest floats on both sides of the edge.
    float above = static_cast<float>(edge);
    if (static_cast<double>(above) < edge) above = std::nextafter(above, 2.0f);
    EXPECT_EQ(encoder.encode(above), c + 1);
    EXPECT_EQ(encoder.encode(std::nextafter(above, 0.0f)), c);
  }
}

TEST(Srgb, ClampsWhatLiesOutside) {
  const SrgbEncoder encoder(65535);
  EXPECT_EQ(encoder.encode(-1.0f), 0);
  EXPECT_EQ(encoder.encode(-0.0f), 0);
  EXPECT_EQ(encoder.encode(1e-30f), 0);
  EXPECT_EQ(encoder.encode(0.49f / 65535 / 12.92f), 0);
  EXPECT_EQ(encoder.encode(0.51f / 65535 / 12.92f), 1);
  EXPECT_EQ(encoder.encode(1.0f), 65535);
  EXPECT_EQ(encoder.encode(INFINITY), 65535);
}

}  // namespace
}  // namespace pentimento
