#include "core/detail/store/tile_planes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "tests/core/detail/painted.h"

namespace pentimento {
namespace {

using test::Painted;
using Values = std::map<TilePlaneId, std::vector<float>>;

Values all_values(const DetailFollower& follower) {
  Values values;
  const DetailCanvas& canvas = follower.canvas();
  for (int t = 0; t < canvas.layout().tiles(); ++t)
    for (const TilePlaneId id : planes_of(canvas, t)) {
      const std::span<const float> plane = values_of(canvas, id);
      values[id].assign(plane.begin(), plane.end());
    }
  return values;
}

TEST(TilePlanes, ACheckpointListsTheSamePlanesAsTheCanvas) {
  Painted painted(96, 4);
  painted.cross_and_dry();
  painted.follower().finish_stamps();
  const DetailCanvas& canvas = painted.follower().canvas();
  std::vector<TilePlaneId> planes;
  for (int t = 0; t < canvas.layout().tiles(); ++t)
    for (const TilePlaneId id : planes_of(canvas, t)) planes.push_back(id);
  EXPECT_EQ(planes_in(painted.follower().checkpoint(), canvas), planes);
  EXPECT_GT(planes.size(), 20u);
}

TEST(TilePlanes, AnotherCanvasGoesOnFromThemBitForBit) {
  Painted one(96, 4), other(96, 4);
  one.cross_and_dry();
  one.follower().finish_stamps();
  const Values values = all_values(one.follower());
  const SimulationMemory memory = one.sim().memory();
  other.sim().set_color(1);  // the hand does the same again
  ASSERT_TRUE(other.follower().recall(one.follower().checkpoint(), one.follower().lock_statistics(),
                                      one.sim().state(), [&](TilePlaneId id, std::span<float> out) {
                                        std::copy(values.at(id).begin(), values.at(id).end(),
                                                  out.begin());
                                        return Result<void>();
                                      }));
  other.sim().recall(clone_state(one.sim().state()), memory);
  one.stroke(2, 0.02, 0.1, 0.18, 0.11);
  other.stroke(2, 0.02, 0.1, 0.18, 0.11);
  // The second canvas numbers its strokes from 1 on; that does not matter where all paint is fresh.
  EXPECT_EQ(all_values(one.follower()).size(), all_values(other.follower()).size());
  EXPECT_EQ(one.follower().lock_statistics().blocks, other.follower().lock_statistics().blocks);
}

TEST(TilePlanes, OnlyPlanesOfTouchedTilesChange) {
  Painted painted(96, 4);
  painted.follower().forget_touched();
  Values before = all_values(painted.follower());
  int untouched = 0;
  const auto check = [&](const char* what) {
    painted.follower().finish_stamps();
    const std::vector<int> touched = painted.follower().touched();
    const Values now = all_values(painted.follower());
    const auto is_touched = [&](const auto& entry) {
      return std::binary_search(touched.begin(), touched.end(), entry.first.tile);
    };
    const auto others = [&](Values values) {
      std::erase_if(values, is_touched);
      return values;
    };
    EXPECT_EQ(others(before), others(now)) << what;
    untouched += static_cast<int>(others(now).size());
    painted.follower().forget_touched();
    before = now;
  };
  painted.stroke(0, 0.03, 0.04, 0.17, 0.1);
  check("a long stroke");
  painted.stroke(1, 0.02, 0.02, 0.04, 0.02);
  check("a short stroke");
  painted.stamp_once(0.15, 0.12);
  check("a tap without a step");
  for (int i = 0; i < 80; ++i) painted.sim().step();
  check("rest, in which planes are freed");
  painted.sim().dry();
  check("drying");
  painted.sim().clear();
  check("a fresh canvas");
  painted.stroke(1, 0.02, 0.02, 0.04, 0.02);
  check("a stroke on it");
  EXPECT_GT(untouched, 0) << "otherwise this test would say nothing";
}

}  // namespace
}  // namespace pentimento
