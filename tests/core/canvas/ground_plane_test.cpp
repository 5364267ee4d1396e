#include "core/canvas/ground_plane.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace pentimento {
namespace {

TEST(GroundPlane, IsItsGroundUntilItIsWritten) {
  GroundPlane plane(5, 3, 0.9f);
  EXPECT_EQ(plane(4, 2), 0.9f);
  plane.write(1, 2, std::array<float, 2>{0.25f, 0.9f});
  plane.set(4, 0, -0.0f);
  EXPECT_EQ(plane(1, 2), 0.25f);
  EXPECT_EQ(plane(2, 2), 0.9f);
  EXPECT_TRUE(std::signbit(plane(4, 0)));
  std::array<float, 3> row{};
  plane.read(0, 2, row);
  EXPECT_EQ(row, (std::array<float, 3>{0.9f, 0.25f, 0.9f}));
  EXPECT_EQ(plane.values()(1, 2), 0.25f);
  EXPECT_EQ(plane.values()(0, 0), 0.9f);
  EXPECT_EQ(plane.ground(), 0.9f);
}

TEST(GroundPlane, AFilledPlaneHasNothingButItsGround) {
  GroundPlane plane(5, 3, 0.9f);
  plane.set(2, 1, 0.1f);
  const GroundPlane copy = plane.clone();
  plane.fill(0.4f);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 5; ++x) {
      EXPECT_EQ(plane(x, y), 0.4f);
      EXPECT_EQ(plane.differences().bits()(x, y), 0u);
    }
  EXPECT_EQ(copy(2, 1), 0.1f);
  EXPECT_EQ(copy(0, 0), 0.9f);
}

}  // namespace
}  // namespace pentimento
