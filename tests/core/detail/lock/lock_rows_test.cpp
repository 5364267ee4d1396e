#include "core/detail/lock/lock_rows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace pentimento {
namespace {

// Blocks with nothing, with nothing wanted, in order, and off by 1e-7 to 30 times.
struct Blocks {
  std::vector<float> wanted, held;
  BlockTargets targets() const { return {wanted.data(), held.data()}; }
  int count() const { return static_cast<int>(wanted.size()); }
};

Blocks all_kinds() {
  Blocks b{{0, 0, 0.25f, 0.25f, 0.25f}, {0, 0.25f, 0, 0.25f, 0.01f}};
  for (const float ratio :
       {1 + 5e-7f, 1 + 2e-6f, 1.0005f, 1.002f, 1.005f, 1.02f, 1.05f, 1.2f,  1.5f,  1.99f, 2.01f,
        0.999999f, 0.9995f,   0.98f,   0.7f,   0.51f,  0.49f, 1e-3f, 15.9f, 16.1f, 30.0f}) {
    b.wanted.push_back(0.01f * ratio);
    b.held.push_back(0.01f);
  }
  return b;
}

TEST(LockRows, RatiosAreThoseOfOneBlockAfterTheOther) {
  const Blocks b = all_kinds();
  std::vector<float> ratio(b.wanted.size());
  EXPECT_TRUE(ratio_row(b.targets(), b.count(), ratio.data()));
  for (std::size_t i = 0; i < ratio.size(); ++i) {
    float plain = 1;
    if (b.wanted[i] > 0 && b.held[i] > 0) {
      const float r = b.wanted[i] / b.held[i];
      if (std::abs(r - 1) > 1e-6f && r >= 0.5f && r <= 2) plain = r;
    }
    EXPECT_EQ(ratio[i], plain) << b.wanted[i] << " for " << b.held[i];
  }
}

TEST(LockRows, RatiosOfBlocksInOrderAreOne) {
  const std::vector<float> same(40, 0.3f), none(40, 0.0f);
  std::vector<float> ratio(40);
  EXPECT_FALSE(ratio_row({same.data(), same.data()}, 40, ratio.data()));
  EXPECT_FALSE(ratio_row({same.data(), none.data()}, 40, ratio.data()));
  EXPECT_FALSE(ratio_row({none.data(), same.data()}, 40, ratio.data()));
  EXPECT_EQ(ratio, std::vector<float>(40, 1.0f));
}

/// The mean of a bilinear field over a block: what scale_by_field() makes of cells of 1.
double mean_under(const RatiosAround& field, int factor, int block) {
  std::vector<float> ones(static_cast<std::size_t>(factor * factor), 1.0f), mean(1);
  scale_by_field(field.from(block), {ones.data(), factor, factor, 1}, mean);
  return static_cast<double>(mean[0]);
}

TEST(LockRows, AFieldIsSharpenedByWhatItLeavesOfBlocksThatAreEven) {
  const Blocks b = all_kinds();
  RatiosAround field;
  for (int row = 0; row < 3; ++row)
    for (int i = -1; i <= b.count(); ++i)
      field.at(row, i) = 1 + 0.05f * static_cast<float>((7 * i + 5 * row + 7) % 6);
  std::vector<float> out(b.wanted.size());
  int changed = 0;
  for (const int k : {1, 2, 3, 8, 15, 32}) {
    sharpen_row(b.targets(), field.from(0), share_of_own_centre(k), b.count(), out.data());
    for (int i = 0; i < b.count(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double wanted = static_cast<double>(b.wanted[at]);
      const double held = static_cast<double>(b.held[at]),
                   before = static_cast<double>(field.at(1, i));
      double left = 1;
      if (wanted > 0 && held > 0) left = wanted / (held * mean_under(field, k, i));
      if (left < 0.5 || left > 2) left = 1;
      // A handful of roundings of floats next to 1.
      EXPECT_NEAR(static_cast<double>(out[at]), before * left, 2e-6) << "k " << k << " block " << i;
      changed += left != 1 ? 1 : 0;
    }
  }
  EXPECT_GT(changed, 60);
}

TEST(LockRows, AFieldThatIsWhatBlocksNeedStaysAsItIs) {
  RatiosAround field;
  for (int row = 0; row < 3; ++row)
    for (int i = -1; i <= 40; ++i) field.at(row, i) = 1.25f;
  const std::vector<float> wanted(40, 0.125f * (1 + 6e-7f)), held(40, 0.1f);
  std::vector<float> out(40);
  sharpen_row({wanted.data(), held.data()}, field.from(0), share_of_own_centre(8), 40, out.data());
  EXPECT_EQ(out, std::vector<float>(40, 1.25f));
}

TEST(LockRows, EachBlockIsCountedInItsBin) {
  const Blocks b = all_kinds();
  RatioCounts plain{}, counts{};
  for (std::size_t i = 0; i < b.wanted.size(); ++i) {
    if (!(b.wanted[i] > 0) || !(b.held[i] > 0)) continue;
    const float r = b.wanted[i] / b.held[i];
    std::size_t bin = 0;
    while (bin < kRatioBounds.size() && std::abs(r - 1) > kRatioBounds[bin]) ++bin;
    ++plain[bin];
  }
  count_ratios(b.targets(), b.count(), counts);
  EXPECT_EQ(counts, plain);
  for (const std::int64_t n : plain) EXPECT_GT(n, 0);  // the blocks above reach each bin
  count_ratios(b.targets(), b.count(), counts);
  for (std::int64_t& n : plain) n *= 2;
  EXPECT_EQ(counts, plain);
}

TEST(LockRows, ScalesAreThoseOfOneBlockAfterTheOther) {
  const Blocks b = all_kinds();
  std::vector<float> scale(b.wanted.size());
  std::vector<std::uint8_t> owed(b.wanted.size());
  EXPECT_TRUE(exact_row(b.targets(), b.count(), scale.data(), owed.data()));
  for (std::size_t i = 0; i < scale.size(); ++i) {
    const float wanted = b.wanted[i], held = b.held[i];
    const bool owes = wanted > 0 && wanted > 16 * held;
    EXPECT_EQ(owed[i], owes ? 1 : 0) << wanted << " for " << held;
    if (!(wanted > 0)) {
      EXPECT_EQ(scale[i], held > 0 ? 0.0f : 1.0f);
    } else {
      EXPECT_EQ(scale[i], owes ? 1.0f : wanted / held) << wanted << " for " << held;
    }
  }
}

TEST(LockRows, BlocksThatHoldWhatTheyShallAreNotScaled) {
  const std::vector<float> same(40, 0.3f), none(40, 0.0f);
  std::vector<float> scale(40);
  std::vector<std::uint8_t> owed(40);
  EXPECT_FALSE(exact_row({same.data(), same.data()}, 40, scale.data(), owed.data()));
  EXPECT_FALSE(exact_row({none.data(), none.data()}, 40, scale.data(), owed.data()));
  EXPECT_EQ(scale, std::vector<float>(40, 1.0f));
}

}  // namespace
}  // namespace pentimento
