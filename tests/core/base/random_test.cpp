#include "core/base/random.h"

#include <gtest/gtest.h>

#include <array>

namespace pentimento {
namespace {

TEST(Random, MixesAsThePublishedSplitMix64) {
  // The reference sequence for seed 1234567.
  EXPECT_EQ(splitmix64(1234567, 1), 6457827717110365317ULL);
  EXPECT_EQ(splitmix64(1234567, 2), 3203168211198807973ULL);
  EXPECT_EQ(splitmix64(1234567, 3), 9817491932198370423ULL);
  EXPECT_EQ(splitmix64(1234567, 4), 4593380528125082431ULL);
  EXPECT_EQ(splitmix64(1234567, 5), 16408922859458223821ULL);
}

TEST(Random, KeepsItsNumbersForEver) {
  EXPECT_EQ(random_uniform(RandomPurpose::kPaperRelief, 0, 0), 0x1.631404p-1f);
  EXPECT_EQ(random_uniform(RandomPurpose::kBristle, 471, 0), 0x1.2e4e72p-1f);
  EXPECT_EQ(random_uniform(RandomPurpose::kBristle, 471, 1), 0x1.0c13e4p-1f);
}

TEST(Random, IsUniform) {
  constexpr int kBins = 64, kDraws = 64 * 1024;
  for (std::uint64_t stroke : {0u, 1u, 77u}) {
    std::array<int, kBins> count{};
    for (int i = 0; i < kDraws; ++i) {
      const float u = random_uniform(RandomPurpose::kBristle, stroke, static_cast<unsigned>(i));
      ASSERT_GE(u, 0.0f);
      ASSERT_LT(u, 1.0f);
      ++count[static_cast<std::size_t>(u * kBins)];
    }
    double chi2 = 0;
    constexpr double kExpected = static_cast<double>(kDraws) / kBins;
    for (int n : count) chi2 += (n - kExpected) * (n - kExpected) / kExpected;
    EXPECT_LT(chi2, 124);  // 63 degrees of freedom: exceeded once in 10^5 draws
    EXPECT_GT(chi2, 24);   // and as rarely below
  }
}

TEST(Random, NeighbouringKeysAreUncorrelated) {
  constexpr int kDraws = 1 << 16;
  std::array<double, 3> sum{};
  for (unsigned i = 0; i < kDraws; ++i) {
    const double u = random_uniform(RandomPurpose::kBristle, 5, i) - 0.5;
    sum[0] += u * (random_uniform(RandomPurpose::kBristle, 5, i + 1) - 0.5);
    sum[1] += u * (random_uniform(RandomPurpose::kBristle, 6, i) - 0.5);
    sum[2] += u * (random_uniform(RandomPurpose::kStampJitter, 5, i) - 0.5);
  }
  // The mean product of independent numbers has standard deviation (1/12)/sqrt(n) = 3.3e-4.
  for (double s : sum) EXPECT_NEAR(s / kDraws, 0.0, 4 * 3.3e-4);
}

}  // namespace
}  // namespace pentimento
