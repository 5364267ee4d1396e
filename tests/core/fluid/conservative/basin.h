#pragma once
// A canvas with paint on it and the conservative scheme to move it, for tests and benchmarks.

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "core/fluid/conservative/conservative_scheme.h"

namespace pentimento::conservative {

struct Basin {
  explicit Basin(const CanvasGeometry& geometry, int layers = 1, int channels = 1, int threads = 1)
      : state(make_canvas_state(geometry, layers, channels, 3, 0.9f)),
        contact(make_brush_contact(geometry.width, geometry.height)),
        pool(threads),
        scheme(geometry),
        amount(static_cast<std::size_t>(channels), 1.0f) {}

  bool step() {
    const StepInput in{model, gravity_m_s2, dt_s, contact, amount, pool, nullptr, fresh};
    const bool changed = scheme.step(state, in);
    ++state.step;
    clear(contact);
    fresh = false;
    return changed;
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) step();
  }
  template <typename Depth>
  void fill_depth(const Depth& depth_at) {
    for (int y = 0; y < state.geometry.height; ++y)
      for (int x = 0; x < state.geometry.width; ++x) state.depth_m(x, y) = depth_at(x, y);
  }
  double statistic(const std::string& name) const {
    for (const auto& [key, value] : scheme.statistics())
      if (key == name) return value;
    return -1;
  }

  CanvasState state;
  Model model;
  BrushContact contact;
  Threads pool;
  ConservativeScheme scheme;
  std::vector<float> amount;
  Vec3f gravity_m_s2{0, 0, 9.81f};
  float dt_s = 1.0f / 45;
  bool fresh = false;  // StepInput::fresh, of the next step
};

/// Sum of a plane, exact to double rounding.
inline double total(const Field<float>& plane) {
  double sum = 0;
  for (int y = 0; y < plane.height(); ++y)
    for (int x = 0; x < plane.width(); ++x) sum += static_cast<double>(plane(x, y));
  return sum;
}
inline float lowest(const Field<float>& plane) {
  float low = plane(0, 0);
  for (int y = 0; y < plane.height(); ++y)
    for (int x = 0; x < plane.width(); ++x) low = std::min(low, plane(x, y));
  return low;
}
inline float highest(const Field<float>& plane) {
  float high = plane(0, 0);
  for (int y = 0; y < plane.height(); ++y)
    for (int x = 0; x < plane.width(); ++x) high = std::max(high, plane(x, y));
  return high;
}
inline bool same_bits(const Field<float>& a, const Field<float>& b) {
  for (int y = 0; y < a.height(); ++y)
    if (std::memcmp(a.row(y), b.row(y), sizeof(float) * static_cast<std::size_t>(a.width())) != 0)
      return false;
  return true;
}

}  // namespace pentimento::conservative
