#include "core/detail/store/detail_canvas.h"

#include <gtest/gtest.h>
#include <sys/mman.h>

#include <array>

#include "tests/core/detail/painted.h"

namespace pentimento {
namespace {

class PruneTest : public ::testing::Test {
 protected:
  PruneTest() {
    DetailTile& tile = canvas_.at(0);
    for (TilePlane& plane : tile.pigment) canvas_.make(plane);
  }
  TilePlane& plane(int pigment) {
    return canvas_.find(0)->pigment[static_cast<std::size_t>(pigment)];
  }
  void give_memory() { canvas_.give_memory(std::array{0}, Threads(1)); }
  const DetailLayout layout_{{8, 8, 1, 1}, 4};
  CanvasState guide_ = make_canvas_state({8, 8, 1, 1}, 2, 1, 3, 0.9f);
  test::PlainSubstrate substrate_;
  std::unique_ptr<TileStore> store_ = std::move(*TileStore::open(
      {static_cast<std::size_t>(layout_.side()) * static_cast<std::size_t>(layout_.side()), "",
       0}));
  DetailCanvas canvas_{layout_, 2, 1, 3, substrate_, *store_};
};

TEST_F(PruneTest, FreesWhatIsEmptyInTheGuideAndHere) {
  guide_.channel(0, 0)(3, 3) = 1;
  canvas_.prune(0, guide_);
  EXPECT_TRUE(plane(0));
  EXPECT_FALSE(plane(1));
}

TEST_F(PruneTest, MakesPlanesOnlyForWhatTheGuideHasInTheBox) {
  for (const int p : {0, 1}) plane(p).free();
  guide_.channel(0, 0)(3, 3) = 1;
  guide_.channel(1, 0)(6, 6) = 1;  // in the same tile, beyond the box
  canvas_.ensure_planes(0, guide_, {2, 5, 2, 5});
  EXPECT_TRUE(plane(0));
  EXPECT_FALSE(plane(1));
}

// At a stroke's edge fine cells keep paint in a layer that the guide's cell has merged away.
TEST_F(PruneTest, KeepsALayerThatOnlyTheDetailHasPaintIn) {
  guide_.channel(0, 0)(3, 3) = 1;
  plane(1).data()[5] = 0.25f;
  canvas_.prune(0, guide_);
  ASSERT_TRUE(plane(1));
  EXPECT_EQ(plane(1).data()[5], 0.25f);
}

/// Whether the first page of a plane is in memory.
bool is_in_memory(TilePlane& plane) {
  unsigned char page = 0;
  EXPECT_EQ(mincore(plane.data(), 1, &page), 0);
  return (page & 1) != 0;
}

TEST_F(PruneTest, GivesMemoryToPlanesMadeSinceTheLastTime) {
  EXPECT_FALSE(is_in_memory(plane(0)));
  give_memory();
  if (!is_in_memory(plane(0))) GTEST_SKIP() << "this system gives pages one by one";
  plane(0).free();
  canvas_.make(plane(0));
  canvas_.make(canvas_.find(0)->depth_m);
  EXPECT_FALSE(is_in_memory(plane(0)));
  give_memory();
  EXPECT_TRUE(is_in_memory(plane(0)));
  EXPECT_TRUE(is_in_memory(canvas_.find(0)->depth_m));
  canvas_.clear();
  give_memory();  // a tile that does not exist: nothing is done
  EXPECT_EQ(canvas_.find(0), nullptr);
}

}  // namespace
}  // namespace pentimento
