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

}  // namespace
}  // namespace pentimento::conservative
