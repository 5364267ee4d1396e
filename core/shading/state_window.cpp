#include "core/shading/state_window.h"

#include <algorithm>
#include <array>

namespace pentimento {
namespace {

/// Four planes, value by value; nullptr stands for a plane of zeros.
void interleave(const std::array<const Field<float>*, 4>& planes, const CanvasGeometry& grid,
                const CellWindow& window, std::vector<float>& texels) {
  const std::vector<float> zeros(static_cast<std::size_t>(grid.width), 0.0f);
  texels.resize(4 * static_cast<std::size_t>(window.width) *
                static_cast<std::size_t>(window.height));
  float* out = texels.data();
  for (int j = 0; j < window.height; ++j) {
    const int y = std::clamp(window.y + j, 0, grid.height - 1);
    std::array<const float*, 4> row{};
    for (std::size_t p = 0; p < 4; ++p) {
      row[p] = planes[p] == nullptr ? zeros.data() : planes[p]->row(y);
    }
    const auto [a, b, c, d] = row;
    for (int i = 0; i < window.width; ++i, out += 4) {
      const int x = std::clamp(window.x + i, 0, grid.width - 1);
      out[0] = a[x];
      out[1] = b[x];
      out[2] = c[x];
      out[3] = d[x];
    }
  }
}

}  // namespace

void pack_ground(const CanvasState& state, const CellWindow& window, std::vector<float>& texels) {
  interleave({&state.reflectance[0], &state.reflectance[1], &state.reflectance[2], &state.depth_m},
             state.geometry, window, texels);
}

void pack_relief(const CanvasState& state, const CellWindow& window, std::vector<float>& texels) {
  const int last_x = state.geometry.width - 1, last_y = state.geometry.height - 1;
  texels.resize(2 * static_cast<std::size_t>(window.width) *
                static_cast<std::size_t>(window.height));
  float* out = texels.data();
  for (int j = 0; j < window.height; ++j) {
    const int y = std::clamp(window.y + j, 0, last_y);
    const float* base = state.base_m.row(y);
    const float* depth = state.depth_m.row(y);
    const float* paper = state.paper_m.row(y);
    for (int i = 0; i < window.width; ++i, out += 2) {
      const int x = std::clamp(window.x + i, 0, last_x);
      out[0] = base[x] + depth[x];
      out[1] = out[0] - paper[x];
    }
  }
}

void pack_amounts(const CanvasState& state, int layer, int plane, const CellWindow& window,
                  std::vector<float>& texels) {
  std::array<const Field<float>*, 4> planes{};
  for (int c = 0; c < 4 && 4 * plane + c < state.channels; ++c) {
    planes[static_cast<std::size_t>(c)] = &state.channel(layer, 4 * plane + c);
  }
  interleave(planes, state.geometry, window, texels);
}

}  // namespace pentimento
