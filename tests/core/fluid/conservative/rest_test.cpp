#include <gtest/gtest.h>

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

}  // namespace
}  // namespace pentimento::conservative
