#include "core/brush/tuft.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/brush/builtin_brushes.h"
#include "core/brush/tip.h"

namespace pentimento {
namespace {

constexpr int kSize = 96;

double sum_of(const Field<float>& map) {
  double sum = 0;
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x) sum += static_cast<double>(map(x, y));
  return sum;
}

std::vector<std::string> bristle_brushes() {
  std::vector<std::string> names;
  for (const std::string& name : builtin_brush_names())
    if (has_bristles(*builtin_brush(name))) names.push_back(name);
  return names;
}

TEST(BristlesTest, PressingBringsMoreOfThemDown) {
  for (const std::string& name : bristle_brushes()) {
    double before = 0;
    for (const float press : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f}) {
      const double sum = sum_of(draw_tip(*builtin_brush(name), kSize, 1, press));
      EXPECT_GT(sum, before) << name << " at " << press;
      before = sum;
    }
  }
}

TEST(BristlesTest, ALightTouchIsNarrowerWithAPointedBundle) {
  const auto width = [](float press) {
    const Field<float> map = draw_tip(*builtin_brush("round"), kSize, 1, press);
    int rows = 0;
    for (int y = 0; y < kSize; ++y) {
      bool touched = false;
      for (int x = 0; x < kSize; ++x) touched |= map(x, y) > 0.05f;
      rows += touched ? 1 : 0;
    }
    return rows;
  };
  EXPECT_LT(width(0.1f), 0.75 * width(1));
}

TEST(BristlesTest, SpreadWithTheSquareOfThePressing) {
  Bristle bristle;
  bristle.length = 1;
  bristle.radius = 0.1f;
  bristle.load = 1;
  bristle.out_v = 0.5f;
  Tuft tuft = tuft_of(TipShape::kBristle);
  for (const float press : {0.1f, 0.5f, 1.0f}) {
    const Field<float> map = draw_tuft(tuft, {bristle}, press, kSize);
    double sum = 0, place = 0;
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        sum += static_cast<double>(map(x, y));
        place += static_cast<double>(map(x, y)) * ((y + 0.5) * 2 / kSize - 1);
      }
    ASSERT_GT(sum, 0) << press;
    // A tenth of a texel: the mark is even about its middle, texels stand 0.02 apart.
    EXPECT_NEAR(place / sum, 0.5 * static_cast<double>(press * press), 2e-3) << press;
  }
}

TEST(BristlesTest, ClumpsLeaveGapsAcrossTheStroke) {
  const auto unevenness = [](float clumping) {
    Tuft tuft = tuft_of(TipShape::kBristle);
    tuft.film = 0;
    tuft.bristles.clumping = clumping;
    const Field<float> map = draw_tuft(tuft, make_bristles(tuft, 7), 1, kSize);
    double sum = 0, square = 0;
    const int margin = kSize / 10;
    for (int y = margin; y < kSize - margin; ++y) {
      double row = 0;
      for (int x = 0; x < kSize; ++x) row += static_cast<double>(map(x, y));
      sum += row;
      square += row * row;
    }
    const double rows = kSize - 2 * margin;
    return std::sqrt(square / rows - sum * sum / (rows * rows)) / (sum / rows);
  };
  EXPECT_GT(unevenness(1), 1.3 * unevenness(0));
}

// Paint a third as thick as in the middle hides what is under it: where that begins is the edge
// that one sees.
TEST(BristlesTest, AStrokesSidesStandInASteepRim) {
  for (const TipShape shape : {TipShape::kRound, TipShape::kFlat, TipShape::kFilbert}) {
    Tuft tuft = tuft_of(shape);
    const Field<float> map = draw_tuft(tuft, make_bristles(tuft, 1), 1, kSize);
    std::vector<double> row(kSize, 0.0);
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x)
        row[static_cast<std::size_t>(y)] += static_cast<double>(map(x, y));
    const double most = *std::max_element(row.begin(), row.end());
    const auto reaches = [&](double share) {
      return std::find_if(row.begin(), row.end(), [&](double r) { return r >= share * most; }) -
             row.begin();
    };
    // 1.2 % of the diameter: three texels, half a millimetre under a brush of 4 cm.
    EXPECT_LE(reaches(0.33) - reaches(0.01), 3);
  }
}

TEST(BristlesTest, RunDryOneByOne) {
  const Tip tip(*builtin_brush("flat"));
  const auto give = [&](float density) {
    const TipLevel level = tip.level_for(0.01f, {1, density});
    const TipLevel wet = tip.level_for(0.01f, {1, 1});
    int all = 0, none = 0, touched = 0;
    for (int i = 0; i < 200; ++i) {
      const float v = -0.45f + 0.0045f * static_cast<float>(i);
      const float full = wet.at(0, v);
      if (!(full > 0.05f)) continue;
      ++touched;
      all += level.at(0, v) > 0.95f * full ? 1 : 0;
      none += level.at(0, v) < 0.3f * full ? 1 : 0;
    }
    return std::array<double, 2>{static_cast<double>(all) / touched,
                                 static_cast<double>(none) / touched};
  };
  EXPECT_EQ(give(0.8f)[0], 1);
  const auto half = give(0.4f);
  EXPECT_GT(half[0], 0.2);  // some still give all,
  EXPECT_GT(half[1], 0.1);  // some next to nothing
  EXPECT_LT(give(0.1f)[0], half[0]);
}

TEST(Tip, BetweenTwoPressingsIsTheirMixtureSoThatGridsAgree) {
  const Tip tip(*builtin_brush("filbert"));
  for (const float press : {0.1f, 0.37f, 0.9f}) {
    for (const double cells : {24.0, 97.0, 233.0}) {
      const TipLevel level = tip.level_for(static_cast<float>(1 / cells), {press, 1});
      double sum = 0;
      for (double y = -0.6; y < 0.6; y += 1 / cells)
        for (double x = -0.6; x < 0.6; x += 1 / cells)
          sum += static_cast<double>(level.at(static_cast<float>(x), static_cast<float>(y)));
      // 1 %: some twenty cells across the tip.
      EXPECT_NEAR(sum / (cells * cells) / static_cast<double>(tip.mean(press)), 1, 0.01)
          << press << ", " << cells;
    }
  }
}

TEST(PressureCurve, IsStraightBetweenItsPointsAndHeldBeyond) {
  PressureCurve curve;
  curve.count = 3;
  curve.points[0] = {0.2f, 0.5f};
  curve.points[1] = {0.4f, 1};
  curve.points[2] = {0.8f, 0};
  EXPECT_FLOAT_EQ(curve.at(0), 0.5f);
  EXPECT_FLOAT_EQ(curve.at(0.3f), 0.75f);
  EXPECT_FLOAT_EQ(curve.at(0.6f), 0.5f);
  EXPECT_FLOAT_EQ(curve.at(1), 0);
}

}  // namespace
}  // namespace pentimento
