#include "core/fluid/paper/pigment.h"

#include <array>
#include <cstring>

#include "core/fluid/paper/departure.h"

namespace pentimento::paper {

namespace {

/// Interpolates a plane whose four cells count with the given parts.
float interpolate_parts(const Field<float>& f, const Departure& p,
                        const std::array<float, 4>& part) {
  const float *a = f.row(p.y0), *b = f.row(p.y1);
  return mix(mix(part[0] * a[p.x0], part[1] * a[p.x1], p.fx),
             mix(part[2] * b[p.x0], part[3] * b[p.x1], p.fx), p.fy);
}

float without_tail(float pigment) {
  return pigment < kNoPigment ? 0.0f : pigment;
}

/// Moves the bottom layer into cell (x, y).
void trace_bottom(const CanvasState& state, const std::vector<float>& amount, float residue,
                  const Departure& from, int x, int y, Planes& planes) {
  const auto loose = [&](int i, int j) { return loose_frac(state, amount, residue, i, j); };
  const std::array<float, 4> parts = {loose(from.x0, from.y0), loose(from.x1, from.y0),
                                      loose(from.x0, from.y1), loose(from.x1, from.y1)};
  const float stuck = 1.0f - loose(x, y);
  for (int c = 0; c < state.channels; ++c) {
    const Field<float>& pigment = state.channel(0, c);
    planes.pigment[static_cast<std::size_t>(c)](x, y) =
        without_tail(interpolate_parts(pigment, from, parts) + stuck * pigment(x, y));
  }
}

/// Moves a layer above into cell (x, y).
void trace_above(const CanvasState& state, int layer, const Departure& from, int x, int y,
                 Planes& planes) {
  for (int c = 0; c < state.channels; ++c)
    planes.pigment[static_cast<std::size_t>(c)](x, y) =
        without_tail(interpolate(state.channel(layer, c), from));
}

}  // namespace

void count_layers_row(const CanvasState& state, int y, Columns cells, Planes& planes) {
  std::uint8_t* occupied = planes.occupied.row(y);
  for (int x = cells.begin; x < cells.end; ++x) {
    int n = 0;
    for (int layer = 0; layer < state.layers; ++layer) {
      float sum = 0;
      for (int c = 0; c < state.channels; ++c) sum += state.channel(layer, c)(x, y);
      n += sum > 0.0f ? 1 : 0;
    }
    occupied[x] = static_cast<std::uint8_t>(n);
  }
}

float loose_frac(const CanvasState& state, const std::vector<float>& amount, float residue, int x,
                 int y) {
  float bottom = 0;
  for (int c = 0; c < state.channels; ++c)
    bottom += amount[static_cast<std::size_t>(c)] * state.channel(0, c)(x, y);
  return bottom > residue ? 1.0f - residue / bottom : 0.0f;
}

void trace_pigment_row(const StepConstants& k, const CanvasState& state,
                       const std::vector<float>& amount, int layer, const float* u_m_s,
                       const float* v_m_s, int y, Columns cells, Planes& planes) {
  const int width = state.geometry.width, height = state.geometry.height;
  const float cells_per_u = k.dt_s / k.dx_m, cells_per_v = k.dt_s / k.dy_m;
  const std::uint8_t* occupied = planes.occupied.row(y);
  for (int c = 0; c < state.channels; ++c)
    std::copy_n(state.channel(layer, c).row(y) + cells.begin, cells.count(),
                planes.pigment[static_cast<std::size_t>(c)].row(y) + cells.begin);
  for (int x = cells.begin; x < cells.end; ++x) {
    if (u_m_s[x] == 0.0f && v_m_s[x] == 0.0f) continue;
    const float share = layer_velocity_frac(layer, occupied[x]);
    const Departure from =
        depart(x, y, share * u_m_s[x] * cells_per_u, share * v_m_s[x] * cells_per_v, width, height);
    if (layer == 0)
      trace_bottom(state, amount, k.residue, from, x, y, planes);
    else
      trace_above(state, layer, from, x, y, planes);
  }
}

bool store_pigment_row(const Planes& planes, int layer, int y, Columns cells, CanvasState& state) {
  bool changed = false;
  const std::size_t bytes = cells.count() * sizeof(float);
  for (int c = 0; c < state.channels; ++c) {
    const float* from = planes.pigment[static_cast<std::size_t>(c)].row(y) + cells.begin;
    float* to = state.channel(layer, c).row(y) + cells.begin;
    if (bytes == 0 || std::memcmp(from, to, bytes) == 0) continue;
    std::memcpy(to, from, bytes);
    changed = true;
  }
  return changed;
}

}  // namespace pentimento::paper
