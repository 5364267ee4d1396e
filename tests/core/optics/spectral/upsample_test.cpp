#include "core/optics/spectral/upsample.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace pentimento {
namespace {

TEST(Upsample, MeetsEveryColourOfTheCubeBetweenZeroAndOne) {
  const SpectrumWeights sight = rgb_weights({});
  for (int i = 0; i < 343; ++i) {
    const std::array<double, 3> rgb = {(i % 7) / 6.0, (i / 7 % 7) / 6.0, (i / 49) / 6.0};
    const Spectrum spectrum = upsample(rgb);
    const auto back = weighted(sight, spectrum);
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(back[c], std::clamp(rgb[c], 0.001, 0.999), 1e-9);
    for (const double r : spectrum) {
      EXPECT_GT(r, 0);
      EXPECT_LT(r, 1);
    }
  }
}

TEST(Upsample, AGreyIsFlat) {
  // To the precision at which Newton stops, since a flat spectrum's RGB is not exactly equal.
  for (const double r : upsample({0.4, 0.4, 0.4})) EXPECT_NEAR(r, 0.4, 1e-6);
}

/// An independent computation of the same minimum, with tables of 10 nm and rows scaled to 1: hence
/// 2e-3 and no less.
TEST(Upsample, MeetsAReferenceForAYellow) {
  const Spectrum yellow = upsample({0.97345, 0.65141, 0.002});
  const double reference[] = {.045920, .057232, .272611, .739910, .834802, .843311, .843688};
  for (std::size_t i = 0; i < std::size(reference); ++i)
    EXPECT_NEAR(yellow[2 + 5 * i], reference[i], 2e-3);  // 400, 450 .. 700 nm
}

TEST(ColorBases, GiveAColourByItsShares) {
  const ColorBases bases;
  const SpectrumWeights sight = rgb_weights({});
  for (const auto& rgb : {std::array{0.2, 0.5, 0.9}, std::array{0.7, 0.7, 0.1},
                          std::array{1.0, 1.0, 1.0}, std::array{0.0, 0.3, 0.0}}) {
    const ColorBases::Shares share = base_shares(rgb);
    Spectrum sum{};
    double whole = 0;
    for (std::size_t i = 0; i < share.size(); ++i) {
      EXPECT_GE(share[i], 0);
      whole += share[i];
      for (std::size_t s = 0; s < sum.size(); ++s) sum[s] += share[i] * bases.basis(i)[s];
    }
    EXPECT_NEAR(whole, 1, 1e-12);
    const auto back = weighted(sight, sum);
    // Corners are moved inside by 0.001.
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(back[c], rgb[c], 0.00101);
  }
}

}  // namespace
}  // namespace pentimento
