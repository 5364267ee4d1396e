#include "core/optics/spectral/bands.h"

#include <gtest/gtest.h>

#include "core/model/viewing.h"
#include "tests/core/optics/spectral/library_mixtures.h"

namespace pentimento {
namespace {

using mixtures::Eye;
using mixtures::largest_difference;

TEST(Bands, HaveRisingWavelengthsInEverySet) {
  for (const int count : band_counts()) {
    const std::vector<double> nm = band_wavelengths_nm(count);
    ASSERT_EQ(static_cast<int>(nm.size()), count);
    EXPECT_TRUE(std::is_sorted(nm.begin(), nm.end()));
    EXPECT_GE(nm.front(), 380);
    EXPECT_LE(nm.back(), 750);
  }
  EXPECT_TRUE(band_wavelengths_nm(5).empty());
}

TEST(Bands, SampleASpectrumLinearlyBetweenItsValues) {
  Spectrum ramp{};
  for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = static_cast<double>(i);
  const std::vector<double> nm = {380, 385, 400, 750, 800, 300};
  EXPECT_EQ(sampled_at(ramp, nm), (std::vector<double>{0, 0.5, 2, 37, 37, 0}));
}

/// The bound that chose the number of bands.
TEST(Bands, TheDefaultKeepsEveryPairOfTheLibraryWithinHalfAUnit) {
  const Eye exact(kSpectrumSamples), few(kDefaultBands);
  EXPECT_LE(largest_difference(exact, few, mixtures::measured_names()), 0.5);
  EXPECT_LE(largest_difference(exact, few, mixtures::all_names()), 0.5);
}

TEST(Bands, TheNextFewerDoNot) {
  const std::span<const int> counts = band_counts();
  const auto at = std::find(counts.begin(), counts.end(), kDefaultBands);
  ASSERT_NE(at, counts.begin());
  EXPECT_EQ(at[-1], kDefaultBands - 1);
  EXPECT_GT(largest_difference(Eye(kSpectrumSamples), Eye(at[-1]), mixtures::all_names()), 0.5);
}

/// docs/optics.md prints these; here so that the table stays true. Two digits.
TEST(Bands, DISABLED_TableOfDifferences) {
  for (const int count : band_counts()) {
    std::printf("| %d |", count);
    for (const auto& names : {mixtures::measured_names(), mixtures::all_names()})
      std::printf(" %.2f |", largest_difference(Eye(kSpectrumSamples), Eye(count), names));
    for (const Illuminant light :
         {Illuminant::kD50, Illuminant::kA, Illuminant::kF2, Illuminant::kF11}) {
      const Viewing viewing{light, Observer::kCie1931};
      std::printf(" %.2f |", largest_difference(Eye(kSpectrumSamples, viewing), Eye(count, viewing),
                                                mixtures::measured_names()));
    }
    const Viewing wide{Illuminant::kD65, Observer::kCie1964};
    std::printf(" %.2f |\n", largest_difference(Eye(kSpectrumSamples, wide), Eye(count, wide),
                                                mixtures::measured_names()));
  }
}

}  // namespace
}  // namespace pentimento
