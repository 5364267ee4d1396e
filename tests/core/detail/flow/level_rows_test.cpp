#include "core/detail/flow/level_rows.h"

#include <gtest/gtest.h>

#include <vector>

namespace pentimento {
namespace {

constexpr int kCells = 5;

TEST(LevelRows, TheEdgeHasAFullAndABareSide) {
  EXPECT_EQ(edge_profile(0), 0);
  EXPECT_EQ(edge_profile(0.85f), 1);
  EXPECT_FLOAT_EQ(edge_profile(0.6f), 0.5f);  // the profile is odd about its middle
  EXPECT_LT(edge_profile(0.35f), 0.01f);      // the skirt
}

/// A film of 1 mm over ground at 2 mm, relaxed by half.
class LevelRowTest : public ::testing::Test {
 protected:
  void level() {
    relax_depth_row({rate_.data(), wet_.data(), film_.data(), substrate_.data()}, base_.data(),
                    kCells, depth_.data());
  }
  std::vector<float> rate_ = {0.5f, 0.5f, 0.5f, 0, 0.5f};
  std::vector<float> wet_ = {1, 1, 1, 1, 0};
  std::vector<float> film_ = {0.001f, 0.001f, 0.001f, 0.001f, 0};
  std::vector<float> substrate_ = std::vector<float>(kCells, 0.002f);
  std::vector<float> base_ = {0.002f, 0.0025f, 0.004f, 0.002f, 0.002f};
  std::vector<float> depth_ = {0.002f, 0.001f, 0.001f, 0.003f, 0.0004f};
};

TEST_F(LevelRowTest, GoesTowardsALevelSurface) {
  level();
  EXPECT_FLOAT_EQ(depth_[0], 0.0015f);
  EXPECT_FLOAT_EQ(depth_[1], 0.00075f);  // over a hump of 0.5 mm
  EXPECT_FLOAT_EQ(depth_[2], 0.0005f);   // over one that stands out
  EXPECT_EQ(depth_[3], 0.003f);          // rate 0
  EXPECT_FLOAT_EQ(depth_[4], 0.0002f);   // no film around
}

TEST_F(LevelRowTest, PigmentComesAndGoesWithTheDepth) {
  const std::vector<float> before = {0.002f, 0.001f, 0.001f, 0.003f, 0};
  const std::vector<float> after = {0.001f, 0.002f, 0.001f, 0.003f, 0.001f};
  const std::vector<float> smooth(kCells, 0.01f), full(kCells, 1.0f);
  std::vector<float> amount = {0.02f, 0.02f, 0.02f, 0.02f, 0};
  relax_pigment_row({rate_.data(), wet_.data(), film_.data(), substrate_.data()},
                    {smooth.data(), film_.data(), full.data()}, before.data(), after.data(), kCells,
                    amount.data());
  EXPECT_FLOAT_EQ(amount[0], 0.01f);
  EXPECT_FLOAT_EQ(amount[1], 0.03f);
  EXPECT_EQ(amount[2], 0.02f);
  EXPECT_EQ(amount[3], 0.02f);
  EXPECT_EQ(amount[4], 0);  // the guide has no film that could say how much
}

TEST_F(LevelRowTest, BesideItsOwnEdgePigmentRelaxesToo) {
  const std::vector<float> smooth(kCells, 0.01f), edge = {0.5f, 0.75f, 1, 0.5f, 0};
  std::vector<float> amount(kCells, 0.02f);
  relax_pigment_row({rate_.data(), wet_.data(), film_.data(), substrate_.data()},
                    {smooth.data(), film_.data(), edge.data()}, depth_.data(), depth_.data(),
                    kCells, amount.data());
  // L = 1/2 towards m(E) a_s / E: m(1/2) = 0.31640625.
  EXPECT_FLOAT_EQ(amount[0], 0.5f * (0.02f + 0.31640625f * 0.02f));
  EXPECT_FLOAT_EQ(amount[1], 0.5f * (0.02f + 0.01f / 0.75f));
  EXPECT_EQ(amount[2], 0.02f);
  EXPECT_EQ(amount[3], 0.02f);
  EXPECT_EQ(amount[4], 0.02f);
}

}  // namespace
}  // namespace pentimento
