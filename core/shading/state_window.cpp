#include "core/shading/state_window.h"

#include <algorithm>

namespace pentimento {
namespace {

/// Calls cell(x, y) for each cell of the window, row by row, and stores what it returns.
template <std::size_t N, typename Cell>
void pack(const CanvasState& state, const CellWindow& window, std::vector<float>& texels,
          Cell&& cell) {
  const int last_x = state.geometry.width - 1, last_y = state.geometry.height - 1;
  texels.resize(N * static_cast<std::size_t>(window.width) *
                static_cast<std::size_t>(window.height));
  float* out = texels.data();
  for (int j = 0; j < window.height; ++j) {
    const int y = std::clamp(window.y + j, 0, last_y);
    for (int i = 0; i < window.width; ++i, out += N) {
      cell(std::clamp(window.x + i, 0, last_x), y, out);
    }
  }
}

}  // namespace

void pack_ground(const CanvasState& state, const CellWindow& window, std::vector<float>& texels) {
  pack<4>(state, window, texels, [&](int x, int y, float* out) {
    for (std::size_t band = 0; band < 3; ++band) out[band] = state.reflectance[band](x, y);
    out[3] = state.depth_m(x, y);
  });
}

void pack_relief(const CanvasState& state, const CellWindow& window, std::vector<float>& texels) {
  pack<2>(state, window, texels, [&](int x, int y, float* out) {
    const float height = state.base_m(x, y) + state.depth_m(x, y);
    out[0] = height;
    out[1] = height - state.paper_m(x, y);
  });
}

void pack_amounts(const CanvasState& state, int layer, int plane, const CellWindow& window,
                  std::vector<float>& texels) {
  const int first = 4 * plane, count = std::clamp(state.channels - first, 0, 4);
  pack<4>(state, window, texels, [&](int x, int y, float* out) {
    for (int c = 0; c < 4; ++c) out[c] = c < count ? state.channel(layer, first + c)(x, y) : 0;
  });
}

}  // namespace pentimento
