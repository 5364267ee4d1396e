#pragma once
// Small strokes on a canvas of 0.2 x 0.15 m, for tests of the simulation.

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "core/brush/stroke_path.h"
#include "core/simulation/simulation.h"
#include "tests/core/three_pigments.h"

namespace pentimento::test {

inline constexpr double kWidth_m = 0.2;
inline constexpr double kHeight_m = 0.15;
inline constexpr float kDiameter_m = 0.02f;
inline constexpr double kSpacing = 0.025;

inline SimulationSetup setup_of(int width, int layers, SchemeKind scheme = SchemeKind::kPaper) {
  SimulationSetup setup;
  setup.geometry = {width, width * 3 / 4, kWidth_m, kHeight_m};
  setup.model.layers = layers;
  setup.model.scheme = scheme;
  setup.basis = palette_channels(three_pigments());
  return setup;
}

struct StrokePlan {
  std::vector<TouchSample> samples;
  int pigment = 0;
  std::uint32_t id = 1;
  int touch = 0;
};

inline TouchSample at(double x_m, double y_m, double time_s, float pressure = -1) {
  TouchSample s;
  s.x_m = x_m;
  s.y_m = y_m;
  s.time_s = time_s;
  s.diameter_m = kDiameter_m;
  s.pressure = pressure;
  return s;
}

inline std::vector<Stamp> stamps_of(const std::vector<TouchSample>& samples,
                                    double spacing = kSpacing) {
  StrokePath path(spacing, kWidth_m, kHeight_m);
  std::vector<Stamp> out;
  path.begin(samples.front());
  for (std::size_t i = 1; i < samples.size(); ++i) path.add(samples[i], out);
  path.finish(out);
  return out;
}

inline bool same_bits(const Field<float>& a, const Field<float>& b) {
  for (int y = 0; y < a.height(); ++y)
    if (std::memcmp(a.row(y), b.row(y), static_cast<std::size_t>(a.width()) * sizeof(float)) != 0)
      return false;
  return true;
}

inline void expect_same_bits(const CanvasState& a, const CanvasState& b) {
  EXPECT_TRUE(same_bits(a.depth_m, b.depth_m));
  EXPECT_TRUE(same_bits(a.base_m, b.base_m));
  for (std::size_t i = 0; i < a.pigment.size(); ++i)
    EXPECT_TRUE(same_bits(a.pigment[i], b.pigment[i])) << "plane " << i;
}

}  // namespace pentimento::test
