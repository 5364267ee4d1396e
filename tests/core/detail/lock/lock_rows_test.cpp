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
