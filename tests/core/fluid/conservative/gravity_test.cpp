#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/core/fluid/conservative/basin.h"

namespace pentimento::conservative {
namespace {

// A wet canvas at the grid's own scale: 3 mm of runny paint with thicker patches, on a weave.
Basin wet_canvas(int width, int height) {
  Basin b({width, height, width / 1024.0, height / 1024.0});
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      b.state.base_m(x, y) = 1e-4f * static_cast<float>((x * 7 + y * 3) % 4);
      b.state.depth_m(x, y) = (x / 20 + y / 20) % 2 == 0 ? 0.003f : 0.006f;
      b.state.channel(0, 0)(x, y) = (x / 30) % 2 == 0 ? 0.005f : 0.06f;
    }
  b.step();
  return b;
}

void expect_whole(const Basin& b, double depth, double pigment, const char* what) {
  EXPECT_EQ(total(b.state.depth_m), depth) << what;
  EXPECT_EQ(total(b.state.channel(0, 0)), pigment) << what;
  EXPECT_TRUE(std::isfinite(highest(b.state.velocity_x_m_s))) << what;
  EXPECT_TRUE(std::isfinite(lowest(b.state.velocity_y_m_s))) << what;
  EXPECT_GE(lowest(b.state.depth_m), 0.0f) << what;
  EXPECT_LE(b.statistic("max_depth_m"), 1.2 * 0.05) << what;
}

struct Pose {
  const char* name;
  Vec3f gravity_m_s2;
};

TEST(ConservativeScheme, SurvivesEveryGravity) {
  for (const Pose& pose : {Pose{"face down", {0, 0, -9.81f}}, Pose{"free fall", {0, 0, 0}},
                           Pose{"upright", {0, -9.81f, 0}}, Pose{"overhead", {5, -5, -6}}}) {
    Basin b = wet_canvas(96, 96);
    const double depth = total(b.state.depth_m);
    const double pigment = total(b.state.channel(0, 0));
    b.gravity_m_s2 = pose.gravity_m_s2;
    b.steps(135);
    expect_whole(b, depth, pigment, pose.name);
  }
}

TEST(ConservativeScheme, SurvivesShakingAt10Hz) {
  for (const float gz : {0.0f, 9.81f}) {
    Basin b = wet_canvas(96, 96);
    const double depth = total(b.state.depth_m);
    const double pigment = total(b.state.channel(0, 0));
    for (int i = 0; i < 225; ++i) {
      const double phase = 2 * 3.14159265358979 * 10 * i / 45;
      b.gravity_m_s2 = {20 * static_cast<float>(std::sin(phase)),
                        20 * static_cast<float>(std::cos(phase)), gz};
      b.step();
    }
    expect_whole(b, depth, pigment, gz > 0 ? "shaken face up" : "shaken in free fall");
  }
}

}  // namespace
}  // namespace pentimento::conservative
