#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <sstream>

#include "tests/core/fluid/conservative/basin.h"

namespace pentimento::conservative {
namespace {

#if defined(PENTIMENTO_SANITIZED)
constexpr int kShare = 2;  // of each side of the canvas: the sanitizers are 25 times slower
#else
constexpr int kShare = 1;
#endif

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
    Basin b = wet_canvas(96 / kShare, 96 / kShare);
    const double depth = total(b.state.depth_m);
    const double pigment = total(b.state.channel(0, 0));
    b.gravity_m_s2 = pose.gravity_m_s2;
    b.steps(135);
    expect_whole(b, depth, pigment, pose.name);
  }
}

TEST(ConservativeScheme, SurvivesShakingAt10Hz) {
  for (const float gz : {0.0f, 9.81f}) {
    Basin b = wet_canvas(96 / kShare, 96 / kShare);
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

// A device picked up, pocketed and carried for 30 s (samples/data/gravity/SOURCE.txt): what it
// reads in units of g, x right, y up, z out, gravity and the hand's own acceleration. Lying face up
// it reads z = -1, so that the specific force is its negative.
std::vector<std::pair<double, Vec3f>> carried() {
  std::ifstream in(PENTIMENTO_SAMPLES "/data/gravity/iphone_balance.csv");
  std::vector<std::pair<double, Vec3f>> out;
  std::string line;
  std::getline(in, line);  // names of the columns
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    std::array<float, 7> v{};
    for (float& x : v) {
      std::string cell;
      std::getline(cells, cell, ',');
      x = std::stof(cell);
    }
    const float g = -9.80665f;
    out.push_back({v[0], {g * (v[1] + v[4]), -g * (v[2] + v[5]), g * (v[3] + v[6])}});
  }
  return out;
}

TEST(ConservativeScheme, SurvivesBeingPickedUpAndCarried) {
  const auto readings = carried();
  ASSERT_GT(readings.size(), 1000u);
  Basin b = wet_canvas(64 / kShare, 48 / kShare);
  const double depth = total(b.state.depth_m);
  const double pigment = total(b.state.channel(0, 0));
  std::size_t k = 0;
  for (int i = 0; i < 30 * 45; ++i) {
    while (k + 1 < readings.size() && readings[k + 1].first <= i / 45.0) ++k;
    b.gravity_m_s2 = readings[k].second;
    b.step();
  }
  expect_whole(b, depth, pigment, "carried");
}

}  // namespace
}  // namespace pentimento::conservative
