#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/core/fluid/conservative/basin.h"

namespace pentimento::conservative {
namespace {

// A level lake 10 mm deep over a cone whose top reaches `top_m`.
Basin lake(float top_m) {
  Basin b({64, 64, 64.0 / 1024, 64.0 / 1024});
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const auto fx = static_cast<float>(x) - 30.2f;
      const auto fy = static_cast<float>(y) - 33.7f;
      const float r = std::sqrt(fx * fx + fy * fy) / 24;
      const float base = std::max(0.0f, top_m * (1 - r));
      b.state.base_m(x, y) = base;
      b.state.depth_m(x, y) = std::max(0.0f, 0.01f - base);
    }
  b.step();  // settles to whole quanta
  return b;
}

TEST(ConservativeScheme, LeavesALakeAtRestBitForBit) {
  for (const float top_m : {0.006f, 0.02f}) {  // submerged, emergent
    Basin b = lake(top_m);
    b.model.wake_gravity_m_s2 = 0;  // and a sleepless one: awake in every step
    const Field<float> depth = b.state.depth_m.clone();
    for (int i = 0; i < 1000; ++i) {
      b.state.sleep.clear();
      ASSERT_TRUE(b.step());
      b.state.sleep.clear();
    }
    EXPECT_TRUE(same_bits(b.state.depth_m, depth)) << top_m;
    EXPECT_EQ(highest(b.state.velocity_x_m_s), 0.0f) << top_m;
    EXPECT_EQ(lowest(b.state.velocity_y_m_s), 0.0f) << top_m;
  }
}

// Two heaps, one in each half of the canvas, on bare ground between them; the right one moves with
// `speed_m_s`. The halves share no cell of any grid of the solves.
Basin two_heaps(float speed_m_s) {
  Basin b({128, 64, 128.0 / 1024, 64.0 / 1024});
  for (const int centre : {30, 96}) {
    for (int y = 20; y < 44; ++y) {
      for (int x = centre - 12; x < centre + 12; ++x) {
        b.state.depth_m(x, y) = 0.0005f + 0.0001f * static_cast<float>((x * 7 + y * 5) % 11);
        if (centre > 64) b.state.velocity_x_m_s(x, y) = speed_m_s;
      }
    }
  }
  b.gravity_m_s2 = {1, 2, 9};
  return b;
}

TEST(ConservativeScheme, WhereNothingMovesAStepDoesWithoutMomentumAndViscosityAtEqualBits) {
  // If anything moves anywhere, all awake cells take the whole way.
  Basin skipping = two_heaps(0), whole = two_heaps(0.005f);
  std::vector<std::string> passes;
  skipping.scheme.on_pass([&](const char* pass) { passes.emplace_back(pass); });
  skipping.step();
  whole.step();
  EXPECT_EQ(std::count(passes.begin(), passes.end(), "masses"), 0);
  const auto left = [](const Field<float>& plane) {
    Field<float> half(64, 64);
    for (int y = 0; y < 64; ++y) std::copy_n(plane.row(y), 64, half.row(y));
    return half;
  };
  EXPECT_GT(highest(left(skipping.state.velocity_x_m_s)), 0.0f) << "it begins to move";
  EXPECT_TRUE(same_bits(left(skipping.state.depth_m), left(whole.state.depth_m)));
  EXPECT_TRUE(same_bits(left(skipping.state.velocity_x_m_s), left(whole.state.velocity_x_m_s)));
  EXPECT_TRUE(same_bits(left(skipping.state.velocity_y_m_s), left(whole.state.velocity_y_m_s)));
}

// A heap of paint that its pigment makes too stiff to give way. If `drop_m` is not 0, a pool of oil
// lies in the same tile, with a drop on it that is so much higher.
Basin stiff_heap(float drop_m) {
  Basin b({64, 64, 64.0 / 1024, 64.0 / 1024});
  for (int y = 4; y < 14; ++y)
    for (int x = 4; x < 14; ++x) {
      b.state.depth_m(x, y) = 0.001f + 0.0001f * static_cast<float>((x * 7 + y * 5) % 11);
      b.state.channel(0, 0)(x, y) = 20 * b.state.depth_m(x, y);
    }
  if (drop_m > 0)
    for (int y = 20; y < 28; ++y)
      for (int x = 20; x < 28; ++x) b.state.depth_m(x, y) = 0.002f;
  b.state.depth_m(23, 23) += drop_m;
  b.gravity_m_s2 = {-2, -3, 9};
  return b;
}

TEST(ConservativeScheme, WherePaintGivesWayToNothingAStepDoesWithoutSolvesAtEqualBits) {
  Basin skipping = stiff_heap(0), whole = stiff_heap(0.001f);
  std::vector<std::string> passes, of_whole;
  skipping.scheme.on_pass([&](const char* pass) { passes.emplace_back(pass); });
  whole.scheme.on_pass([&](const char* pass) { of_whole.emplace_back(pass); });
  for (int i = 0; i < 3; ++i) {
    skipping.state.sleep.clear();  // awake in every step
    whole.state.sleep.clear();
    skipping.step();
    whole.step();
  }
  EXPECT_EQ(std::count(passes.begin(), passes.end(), "height"), 0);
  EXPECT_EQ(std::count(of_whole.begin(), of_whole.end(), "height"), 3) << "oil runs beside it";
  EXPECT_GT(highest(whole.state.velocity_x_m_s), 0.0f);
  const auto corner = [](const Field<float>& plane) {
    Field<float> cells(16, 16);
    for (int y = 0; y < 16; ++y) std::copy_n(plane.row(y), 16, cells.row(y));
    return cells;
  };
  for (const auto plane :
       {&CanvasState::depth_m, &CanvasState::velocity_x_m_s, &CanvasState::velocity_y_m_s})
    EXPECT_TRUE(same_bits(corner(skipping.state.*plane), corner(whole.state.*plane)));
  EXPECT_EQ(highest(skipping.state.velocity_y_m_s), 0.0f);
}

TEST(ConservativeScheme, StiffPaintThatMovesIsSlowedDown) {
  Basin b = stiff_heap(0);
  b.state.velocity_x_m_s(8, 8) = 0.02f;
  b.step();
  EXPECT_LT(highest(b.state.velocity_x_m_s), 0.01f) << "by its neighbours and the bed";
}

TEST(ConservativeScheme, AStepDependsOnTheStateAlone) {
  // Two pools, each over the border of two tiles, which share only coarse cells. The first comes to
  // rest while the second still runs. What the solves left behind in its tiles must not reach the
  // second: a scheme that has seen nothing of it takes the same steps.
  Basin b({256, 256, 0.25, 0.25});
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 12; ++x) {
      b.state.depth_m(58 + x, 10 + y) = x < 6 ? 0.003f : 0.002f;
      b.state.depth_m(122 + x, 74 + y) =
          0.003f + 0.0015f * static_cast<float>((x * 7 + y * 5) % 11);
    }
  int all_awake = 0, second_awake = 0;
  for (int i = 0; i < 30; ++i) {
    Basin fresh(b.state.geometry);
    fresh.state = clone_state(b.state);
    b.step();
    fresh.step();
    for (const auto plane :
         {&CanvasState::depth_m, &CanvasState::velocity_x_m_s, &CanvasState::velocity_y_m_s})
      ASSERT_TRUE(same_bits(b.state.*plane, fresh.state.*plane)) << "step " << i;
    all_awake += b.scheme.awake_share() == 4.0 / 64 ? 1 : 0;
    second_awake += b.scheme.awake_share() == 2.0 / 64 ? 1 : 0;
  }
  EXPECT_GT(all_awake, 3);
  EXPECT_GT(second_awake, 3);
}

TEST(ConservativeScheme, StiffPaintIsSolvedForWhereGravityMovesItToo) {
  Basin b = stiff_heap(0);
  b.model.phi_scales_lateral = false;  // reading (b) of A7: stiff paint slides
  b.model.velocity_threshold_m_s = 0;  // however slowly
  b.step();
  EXPECT_GT(highest(b.state.velocity_y_m_s), 0.0f);
}

}  // namespace
}  // namespace pentimento::conservative
