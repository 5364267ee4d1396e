// What a cell of the detail canvas takes: docs/bench/poster.md states these figures.

#include <gtest/gtest.h>

#include "tests/core/detail/painted.h"

namespace pentimento {
namespace {

std::int64_t tiles_of(const DetailCanvas& canvas) {
  std::int64_t count = 0;
  for (int t = 0; t < canvas.layout().tiles(); ++t) count += canvas.find(t) != nullptr ? 1 : 0;
  return count;
}

/// Bytes of planes per cell of the tiles that exist.
double bytes_per_cell(const test::Painted& painted) {
  const DetailCanvas& canvas = painted.follower().canvas();
  const double cells =
      static_cast<double>(tiles_of(canvas)) * canvas.layout().side() * canvas.layout().side();
  return static_cast<double>(painted.store().bytes()) / cells;
}

TEST(TileMemory, BareCanvasTakesNone) {
  const test::Painted painted(128, 8);
  EXPECT_EQ(tiles_of(painted.follower().canvas()), 0);
  EXPECT_EQ(painted.store().bytes(), 0);
}

TEST(TileMemory, ATileTakesThePigmentsThatItHas) {
  test::Painted painted(128, 8);
  painted.stroke(0, 0.03, 0.04, 0.17, 0.1);
  // Depth, base, and one pigment in up to two layers: three or four floats. (The least is that
  // of a tile in which nothing lies yet.)
  EXPECT_GT(bytes_per_cell(painted), 8);
  EXPECT_LE(bytes_per_cell(painted), 16);
  EXPECT_LT(tiles_of(painted.follower().canvas()), painted.follower().canvas().layout().tiles());
  painted.cross();
  // At most three pigments where strokes cross: eight floats.
  EXPECT_LE(bytes_per_cell(painted), 32);
}

TEST(TileMemory, DryPaintIsReliefAndThreeColours) {
  test::Painted painted(128, 8);
  painted.cross();
  painted.sim().dry();
  EXPECT_GT(bytes_per_cell(painted), 12);
  EXPECT_LE(bytes_per_cell(painted), 16);
}

}  // namespace
}  // namespace pentimento
