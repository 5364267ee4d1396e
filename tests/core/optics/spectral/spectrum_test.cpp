#include "core/optics/spectral/spectrum.h"

#include <gtest/gtest.h>

#include "core/optics/spectral/illuminant.h"

namespace pentimento {
namespace {

struct White {
  Illuminant illuminant;
  Observer observer;
  double x, y;
  double tolerance;
};
// Published to five digits where the CIE tabulates at 1 nm (here: 5 nm, which moves the fifth), to
// four for the lamps (CIE 15:2004, table T.3 and its notes).
constexpr White kWhites[] = {
    {Illuminant::kA, Observer::kCie1931, 0.44758, 0.40745, 2e-5},
    {Illuminant::kA, Observer::kCie1964, 0.45117, 0.40594, 2e-5},
    {Illuminant::kD50, Observer::kCie1931, 0.34567, 0.35851, 2e-5},
    {Illuminant::kD50, Observer::kCie1964, 0.34773, 0.35952, 2e-5},
    {Illuminant::kD55, Observer::kCie1931, 0.33243, 0.34744, 2e-5},
    {Illuminant::kD65, Observer::kCie1931, 0.31272, 0.32903, 2e-5},
    {Illuminant::kD65, Observer::kCie1964, 0.31381, 0.33098, 2e-5},
    {Illuminant::kD75, Observer::kCie1931, 0.29903, 0.31488, 2e-5},
    {Illuminant::kE, Observer::kCie1931, 1.0 / 3, 1.0 / 3, 2e-5},
    {Illuminant::kF2, Observer::kCie1931, 0.3721, 0.3751, 6e-5},
    {Illuminant::kF11, Observer::kCie1931, 0.3805, 0.3769, 6e-5},
};

TEST(Illuminants, HaveTheirPublishedWhitePoints) {
  for (const White& w : kWhites) {
    const Xyz white = white_xyz({w.illuminant, w.observer});
    const double sum = white[0] + white[1] + white[2];
    EXPECT_NEAR(white[0] / sum, w.x, w.tolerance) << static_cast<int>(w.illuminant);
    EXPECT_NEAR(white[1] / sum, w.y, w.tolerance) << static_cast<int>(w.illuminant);
    EXPECT_NEAR(white[1], 1, 1e-12);
  }
}

TEST(Illuminants, HaveTheirPublishedPower) {
  const CieSpectrum A = illuminant_power(Illuminant::kA), D50 = illuminant_power(Illuminant::kD50);
  const CieSpectrum D65 = illuminant_power(Illuminant::kD65);
  EXPECT_NEAR(A[0], 9.7951, 5e-5);     // 380 nm
  EXPECT_NEAR(A[80], 241.675, 5e-4);   // 780 nm
  EXPECT_NEAR(D65[0], 49.9755, 6e-3);  // the CIE's own steps round once more
  EXPECT_NEAR(D65[34], 104.046, 6e-3);
  EXPECT_NEAR(D50[14], 87.247, 6e-3);
}

TEST(RgbWeights, MakeAPerfectWhiteWhiteInEveryLight) {
  Spectrum white{};
  white.fill(1);
  for (const White& w : kWhites) {
    // The adaptation is exact for the white; 1e-9: rounding of matrices.
    for (const double c : weighted(rgb_weights({w.illuminant, w.observer}), white))
      EXPECT_NEAR(c, 1, 1e-9);
  }
}

TEST(RgbWeights, AgreeWithThePublishedMatrixOfSrgb) {
  // IEC 61966-2-1, four digits; D65 needs hardly any adaptation.
  const Matrix3 m = xyz_to_rgb(white_xyz({}));
  const double published[3][3] = {
      {3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(m[i][j], published[i][j], 1e-3);
}

TEST(RgbWeights, AdaptAsBradfordPublished) {
  // Lindbloom's matrix from D50 to D65: X of a colour (1,0,0), and so on by columns.
  const Xyz d50 = {0.96422, 1, 0.82521};
  const Matrix3 from = xyz_to_rgb(d50);
  // Lindbloom: XYZ (D50) to sRGB.
  const double published[3][3] = {{3.1338561, -1.6168667, -0.4906146},
                                  {-0.9787684, 1.9161415, 0.0334540},
                                  {0.0719453, -0.2289914, 1.4052427}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(from[i][j], published[i][j], 1.5e-3);
}

}  // namespace
}  // namespace pentimento
