#include "core/detail/store/detail_source.h"

#include <gtest/gtest.h>

#include "tests/core/detail/painted.h"

namespace pentimento {
namespace {

TEST(DetailSource, ReadsAcrossTiles) {
  test::Painted painted(128, 8);
  painted.cross();
  const DetailCanvas& canvas = painted.follower().canvas();
  const CanvasState& guide = painted.sim().state();
  const DetailSource source(canvas, guide);
  EXPECT_EQ(source.geometry().width, 1024);
  std::vector<float> row(1024);
  double sum = 0;
  for (int y = 0; y < 8; ++y) {
    source.read({PlaneKind::kDepth}, 0, 48 * 8 + y, row);
    for (const float d : row) sum += static_cast<double>(d);
  }
  double wanted = 0;
  for (int x = 0; x < 128; ++x) wanted += 64 * static_cast<double>(guide.depth_m(x, 48));
  EXPECT_NEAR(sum / wanted, 1, 1e-6);  // the lock's rounding
}

TEST(DetailSource, ShowsTheGroundWhereNothingWasPainted) {
  test::Painted painted(64, 4);
  const DetailSource source(painted.follower().canvas(), painted.sim().state());
  std::vector<float> cells(5, -1.0f);
  source.read(reflectance_plane(1), 100, 50, cells);
  EXPECT_EQ(cells, std::vector<float>(5, 0.9f));
  EXPECT_TRUE(source.empty({0, 0, 256, 192}));
}

TEST(DetailSource, InterpolatesTheGuidesVelocity) {
  CanvasState guide = make_canvas_state({8, 8, 1, 1}, 1, 1, 3, 1.0f);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 7; ++x) guide.velocity_x_m_s(x, y) = static_cast<float>(x + 1);
  test::PlainSubstrate substrate;
  const std::unique_ptr<TileStore> store = std::move(*TileStore::open({128 * 128, "", 0}));
  const DetailCanvas canvas(DetailLayout({8, 8, 1, 1}, 4), 1, 1, 3, substrate, *store);
  const DetailSource source(canvas, guide);
  std::vector<float> u(16);
  source.read({PlaneKind::kVelocityX}, 0, 9, u);
  // Right face of fine cell i at (i + 1) / 4 cells: the guide's face x holds x + 1, the wall 0.
  for (int i = 0; i < 16; ++i) EXPECT_FLOAT_EQ(u[static_cast<std::size_t>(i)], (i + 1) / 4.0f);
}

TEST(DetailSource, ReadingLeavesNoMoreInMemoryThanTheStoreMayHold) {
  TileStoreOptions scratch;
  scratch.scratch = testing::TempDir();
  scratch.resident_bytes = 512 << 10;  // 8 planes of some 60
  test::Painted painted(128, 4, Threads(2), true, scratch);
  painted.stroke(0, 0.02, 0.02, 0.1, 0.1);
  const DetailSource source(painted.follower().canvas(), painted.sim().state());
  std::vector<float> row(512);
  // Every 8192nd read trims. It is one of a cell that has no tile, which brings none into memory.
  for (int i = 0; i < 8191; ++i) source.read({PlaneKind::kDepth}, 0, i % 384, row);
  EXPECT_GT(painted.store().held_bytes(), scratch.resident_bytes);
  ASSERT_TRUE(source.empty({511, 383, 1, 1}));
  source.read({PlaneKind::kDepth}, 511, 383, {row.data(), 1});
  EXPECT_LE(painted.store().held_bytes(), scratch.resident_bytes);
}

TEST(DetailSource, GivesStrokesOfTheGuide) {
  test::Painted painted(64, 4);
  painted.stroke(0, 0.05, 0.05, 0.1, 0.1);
  const DetailSource source(painted.follower().canvas(), painted.sim().state());
  std::vector<std::uint32_t> ids(256);
  source.read_strokes(0, 100, ids);
  for (int x = 0; x < 256; ++x)
    EXPECT_EQ(ids[static_cast<std::size_t>(x)], painted.sim().state().stroke(x / 4, 25));
}

}  // namespace
}  // namespace pentimento
