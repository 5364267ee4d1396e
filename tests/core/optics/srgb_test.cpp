#include "core/optics/srgb.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pentimento {
namespace {

TEST(Srgb, AgreesWithTheStandardsFormula) {
  for (std::size_t i = 0; i < 256; ++i) {
    const double c = static_cast<double>(i) / 255;
    const double expected = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    // The power function is good to a few units in the last place of a double.
    EXPECT_NEAR(kSrgb8ToLinear[i], expected, 4e-15) << i;
  }
}

TEST(Srgb, PublishedValuesComeOut) {
  EXPECT_EQ(kSrgb8ToLinear[0], 0.0);
  // The curve's constants meet 1 to rounding of the power function.
  EXPECT_NEAR(kSrgb8ToLinear[255], 1.0, 1e-15);
  // Middle grey: sRGB 119 is 18.4 % reflectance (4 digits published).
  EXPECT_NEAR(kSrgb8ToLinear[119], 0.1845, 5e-5);
}

TEST(Srgb, EncodingUndoesDecoding) {
  for (std::size_t i = 0; i < 256; ++i) {
    // The two branches of the standard meet only to 1e-7 at the joint.
    EXPECT_NEAR(linear_to_srgb(kSrgb8ToLinear[i]) * 255, static_cast<double>(i), 1e-4);
  }
}

}  // namespace
}  // namespace pentimento
