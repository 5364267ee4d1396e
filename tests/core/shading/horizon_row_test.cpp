#include "core/shading/horizon_row.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace pentimento {
namespace {

/// Heights of 9 x 9 cells of a millimetre with a border, and the row in their middle.
struct Patch {
  explicit Patch(const auto& height_of) {
    for (int y = -kBorder; y < kSide + kBorder; ++y)
      for (int x = -kBorder; x < kSide + kBorder; ++x) heights.push_back(height_of(x, y));
  }
  HeightRows rows() const {
    constexpr std::ptrdiff_t kStride = kSide + 2 * kBorder;
    return {heights.data() + (kSide / 2 + kBorder) * kStride + kBorder, kStride, 1e-3f, 1e-3f};
  }
  static constexpr int kSide = 9, kBorder = 8;
  std::vector<float> heights;
};

HorizonLines lines() {
  return horizon_lines({90, 90, 0.09, 0.09});
}

std::vector<float> sky(const Patch& patch) {
  std::vector<float> seen(Patch::kSide);
  sky_seen_row(patch.rows(), lines(), seen);
  return seen;
}
std::vector<float> lamp(const Patch& patch, const std::array<float, 3>& direction) {
  std::vector<float> seen(Patch::kSide);
  lamp_seen_row(patch.rows(), lines(), direction, seen);
  return seen;
}

TEST(SkySeenRow, IsAllOfItOnAPlaneHoweverSteep) {
  for (const float slope : {0.0f, 0.7f}) {
    for (const float seen :
         sky(Patch([&](int x, int y) { return slope * 1e-3f * (x - 2.0f * y); })))
      EXPECT_NEAR(seen, 1, 1e-6);  // rounding
  }
}

TEST(SkySeenRow, AtTheFootOfAWallFollowsFromItsHeight) {
  // A wall of 2 mm right of cell 4. In the directions at 22.5 and -22.5 degrees it begins one cell
  // on, at 67.5 and -67.5 degrees two rows and a cell on: rise 1.5 (over the slope) is not reached
  // there.
  const Patch patch([](int x, int) { return x > 4 ? 2e-3f : 0.0f; });
  const std::vector<float> seen = sky(patch);
  EXPECT_LT(seen[4], seen[3]);
  EXPECT_LT(seen[3], seen[1]);
  EXPECT_NEAR(seen[8], 1, 1e-6);  // on top: nothing is higher
  for (const float s : seen) EXPECT_GT(s, 0);
}

TEST(LampSeenRow, IsHalfAtTheHorizonAndNoneWellBelowIt) {
  const Patch wall([](int x, int) { return x > 4 ? 2e-3f : 0.0f; });
  // From cell 3 the wall is two cells off and 2 mm high: 45 degrees.
  EXPECT_NEAR(lamp(wall, {0.6f, 0, 0.6f})[3], 0.5f, 1e-5f);
  EXPECT_EQ(lamp(wall, {0.6f, 0, 0.3f})[3], 0);
  EXPECT_EQ(lamp(wall, {0.6f, 0, 0.9f})[3], 1);
  EXPECT_EQ(lamp(wall, {-0.6f, 0, 0.3f})[3], 1);  // from the other side
  EXPECT_EQ(lamp(wall, {0, 0, 1})[4], 1);         // from above
  EXPECT_EQ(lamp(wall, {0.6f, 0, -0.1f})[3], 1);  // below the canvas: it does not shine anyway
}

TEST(NearLampSeenRow, FarAwayIsTheFarLamp) {
  const Patch bumps([](int x, int y) { return 5e-4f * static_cast<float>((x * 7 + y * 3) % 5); });
  const std::array<float, 3> direction = {0.6f, 0.48f, 0.64f};
  const std::vector<float> far = lamp(bumps, direction);
  std::vector<float> near(Patch::kSide);
  constexpr float kFar_m = 1e4f;
  near_lamp_seen_row(bumps.rows(), lines(),
                     {{direction[0] * kFar_m, direction[1] * kFar_m, direction[2] * kFar_m},
                      {0.045f, 0.045f},
                      40,
                      44,
                      1},
                     near);
  for (std::size_t x = 0; x < far.size(); ++x)
    EXPECT_NEAR(near[x], far[x], 1e-4);  // 0.1 m in 10 km
}

}  // namespace
}  // namespace pentimento
