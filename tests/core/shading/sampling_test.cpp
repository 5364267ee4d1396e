#include "core/shading/sampling.h"

#include <gtest/gtest.h>

#include "core/shading/tile_plan.h"

namespace pentimento {
namespace {

TEST(AxisWindow, AtTheGridsSizeEverySampleIsACell) {
  const AxisWindow w = axis_window({100, 100, 1}, 10, 3);
  EXPECT_EQ(w.first_cell, 8);
  EXPECT_EQ(w.cells, 7);
  EXPECT_EQ(w.table, (std::vector<float>{2, 0, 3, 0, 4, 0}));
}

TEST(AxisWindow, EnlargedFourTimesSamplesLieAtOddEighths) {
  const AxisWindow w = axis_window({10, 40, 1}, 4, 4);
  EXPECT_EQ(w.first_cell, -2);  // cell 0 and the two before it
  EXPECT_EQ(w.table, (std::vector<float>{2, .625f, 2, .875f, 3, .125f, 3, .375f}));
}

TEST(AxisWindow, ReducedTwiceSamplesEachCellOnce) {
  EXPECT_EQ(samples_per_pixel(100, 50), 2);
  EXPECT_EQ(samples_per_pixel(100, 99), 2);
  EXPECT_EQ(samples_per_pixel(50, 100), 1);
  const AxisWindow w = axis_window({100, 50, 2}, 0, 2);
  EXPECT_EQ(w.table, (std::vector<float>{2, 0, 3, 0, 4, 0, 5, 0}));
}

TEST(AxisWindow, FractionsDoNotDependOnTheTile) {
  const SampleAxis axis{1000, 16384, 1};
  const AxisWindow whole = axis_window(axis, 0, 16384);
  for (const int first : {1, 511, 9999}) {
    const AxisWindow part = axis_window(axis, first, 64);
    for (std::size_t i = 0; i < 64; ++i) {
      const std::size_t at = 2 * (static_cast<std::size_t>(first) + i);
      EXPECT_EQ(part.table[2 * i + 1], whole.table[at + 1]);
      EXPECT_EQ(part.table[2 * i] + static_cast<float>(part.first_cell),
                whole.table[at] + static_cast<float>(whole.first_cell));
    }
    EXPECT_LE(part.cells, axis.most_cells(64));
  }
}

TEST(AxisWindow, NeverExceedsWhatItPromises) {
  for (const SampleAxis axis : {SampleAxis{7, 1000, 1}, SampleAxis{1000, 999, 2},
                                SampleAxis{1000, 37, 28}, SampleAxis{1, 1, 1}}) {
    for (int first = 0; first < axis.pixels; first += 3) {
      const int count = std::min(5, axis.pixels - first);
      EXPECT_LE(axis_window(axis, first, count).cells, axis.most_cells(count));
    }
  }
}

TEST(AveragesCells, ByNoWholeFactorAndByAVeryLargeOne) {
  EXPECT_FALSE(averages_cells(100, 50, 100, 50));
  EXPECT_FALSE(averages_cells(100, 50, 50, 25));
  EXPECT_TRUE(averages_cells(100, 50, 40, 20));    // 2.5 cells
  EXPECT_TRUE(averages_cells(100, 50, 50, 50));    // 2 cells along x alone
  EXPECT_FALSE(averages_cells(100, 50, 200, 40));  // larger along x
  EXPECT_FALSE(averages_cells(2048, 2048, 1, 1));
  EXPECT_TRUE(averages_cells(2049, 2049, 1, 1));
  EXPECT_TRUE(averages_cells(16384, 16384, 4, 4));
}

TileDemand demand(int cells, int pixels, int tile) {
  return {{cells, pixels, samples_per_pixel(cells, pixels)},
          {cells, pixels, samples_per_pixel(cells, pixels)},
          {0, pixels},
          {0, pixels},
          tile,
          2,
          1,
          3};
}

TEST(TilePlan, CoversTheCropOnce) {
  TileDemand d = demand(100, 1000, 300);
  d.crop_x = {150, 700};
  const TilePlan plan = plan_tiles(d);
  int next = 150;
  for (const PixelRun& run : plan.columns) {
    EXPECT_EQ(run.first, next);
    EXPECT_LE(run.count, 300);
    next += run.count;
  }
  EXPECT_EQ(next, 850);
  EXPECT_EQ(plan.rows.size(), 4u);
}

TEST(TilePlan, KeepsTexturesUnderTheirLimitsForPosters) {
  // Grids of 20000 cells and 8 layers of 8 channels, pictures of any size: textures stay under 1
  // GiB, beyond which Mesa fails, and under its 16384 texels a side.
  for (const int pixels : {500, 5000, 20000, 60000}) {
    TileDemand d = demand(20000, pixels, 4096);
    d.input_texels = 16;
    d.targets = 8;
    d.planes = 25;
    const TilePlan plan = plan_tiles(d);
    const std::int64_t w = d.x.most_cells(plan.width), h = d.y.most_cells(plan.height);
    EXPECT_LE(w, 4096);
    EXPECT_LE(w * h * 16 * 16, std::int64_t{1} << 30);
    EXPECT_LE(plan.width * d.x.per_pixel, 16384);
    EXPECT_LE(std::int64_t{plan.width} * plan.height * 16 * 8, std::int64_t{1} << 30);
  }
}

TEST(TilePlan, LeavesRoomForTheReliefsBorder) {
  // A cell a pixel, at most 4096 of them with those around the run's own: 4000 leave room for 80
  // cells of relief on one side, not on both. Half of them is the next count tried.
  TileDemand d = demand(20000, 20000, 4000);
  EXPECT_EQ(plan_tiles(d).width, 4000);
  d.border = 80;
  const TilePlan plan = plan_tiles(d);
  EXPECT_EQ(plan.width, 2000);
  EXPECT_LE(d.x.most_cells(plan.width) + 2 * 80, 4096);
  EXPECT_LE(d.y.most_cells(plan.height) + 2 * 80, 4096);
}

}  // namespace
}  // namespace pentimento
