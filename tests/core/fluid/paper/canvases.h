#pragma once
// Canvases for the tests of the published scheme.

#include <cmath>
#include <cstring>

#include "core/base/random.h"
#include "core/fluid/paper/paper_scheme.h"

namespace pentimento::paper {

inline bool same_bits(const Field<float>& a, const Field<float>& b) {
  for (int y = 0; y < a.height(); ++y)
    if (std::memcmp(a.row(y), b.row(y), static_cast<std::size_t>(a.width()) * sizeof(float)) != 0)
      return false;
  return true;
}

inline double sum(const Field<float>& f) {
  double total = 0;
  for (int y = 0; y < f.height(); ++y)
    for (int x = 0; x < f.width(); ++x) total += f(x, y);
  return total;
}

/// Whether every value is finite, and in [low, high].
inline bool within(const Field<float>& f, float low, float high) {
  for (int y = 0; y < f.height(); ++y)
    for (int x = 0; x < f.width(); ++x)
      if (!(f(x, y) >= low && f(x, y) <= high)) return false;
  return true;
}

/// A canvas, its scheme and what drives them. Cells of Table 1 unless a geometry says otherwise.
struct TestCanvas {
  TestCanvas(int width, int height, int layers = 2, int channels = 2, int thread_count = 1)
      : TestCanvas({width, height, width / 1024.0, height / 768.0}, layers, channels,
                   thread_count) {}
  explicit TestCanvas(const CanvasGeometry& geometry, int layers = 2, int channels = 2,
                      int thread_count = 1)
      : threads(thread_count),
        contact(make_brush_contact(geometry.width, geometry.height)),
        amount(static_cast<std::size_t>(channels), 1.0f),
        state(make_canvas_state(geometry, layers, channels, 3, 0.9f)),
        scheme(state.geometry, layers, channels) {}

  bool step() { return scheme.step(state, {model, gravity, dt_s, contact, amount, threads}); }
  void steps(int n) {
    for (int i = 0; i < n; ++i) step();
  }
  void pour(int x0, int y0, int x1, int y1, float depth_m, float pigment, int layer = 0) {
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) {
        state.depth_m(x, y) = depth_m;
        state.channel(layer, 0)(x, y) = pigment;
      }
  }
  void flood(float depth_m, float pigment) {
    pour(0, 0, state.geometry.width, state.geometry.height, depth_m, pigment);
  }
  /// A canvas weave with bumps up to `height_m`, the same on every run.
  void roughen(float height_m) {
    for (int y = 0; y < state.geometry.height; ++y)
      for (int x = 0; x < state.geometry.width; ++x)
        state.base_m(x, y) =
            height_m * random_uniform(RandomPurpose::kPaperRelief, static_cast<unsigned>(x),
                                      static_cast<unsigned>(y));
  }
  void touch(int x0, int y0, int x1, int y1, float u, float v) {
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) {
        contact.weight(x, y) = 0.5f;
        contact.velocity_x_m_s(x, y) = u;
        contact.velocity_y_m_s(x, y) = v;
      }
    contact.touch(x0, x1, y0, y1);
  }

  Model model;
  Vec3f gravity{0, 0, 9.81f};
  float dt_s = 1.0f / 45;
  Threads threads;
  BrushContact contact;
  std::vector<float> amount;
  CanvasState state;
  PaperScheme scheme;
};

inline bool same_state(const CanvasState& a, const CanvasState& b) {
  bool same = same_bits(a.depth_m, b.depth_m) && same_bits(a.velocity_x_m_s, b.velocity_x_m_s) &&
              same_bits(a.velocity_y_m_s, b.velocity_y_m_s);
  for (std::size_t i = 0; i < a.pigment.size(); ++i)
    same = same && same_bits(a.pigment[i], b.pigment[i]);
  return same;
}

inline CanvasState copy_of(const CanvasState& s) {
  CanvasState c = make_canvas_state(s.geometry, s.layers, s.channels, s.bands, 0);
  c.depth_m = s.depth_m.clone();
  c.velocity_x_m_s = s.velocity_x_m_s.clone();
  c.velocity_y_m_s = s.velocity_y_m_s.clone();
  c.base_m = s.base_m.clone();
  for (std::size_t i = 0; i < s.pigment.size(); ++i) c.pigment[i] = s.pigment[i].clone();
  return c;
}

}  // namespace pentimento::paper
