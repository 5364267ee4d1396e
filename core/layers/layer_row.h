#pragma once
// The pigment of one row of cells in all layers and channels. The kernels of this folder read and
// write it. It is a view; a copy shows the same values.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/canvas/canvas_state.h"
#include "core/model/model.h"
#include "core/optics/composite.h"

namespace pentimento {

struct LayerRow {
  std::span<float* const> plane;  // [layer * channels + channel]
  std::ptrdiff_t offset = 0;      // of the row's cell 0 in each plane
  int layers = 1;
  int channels = 0;
  std::span<const float> amount;  // per channel: its share in the total amount (A26)
  // Per plane: 0 if these cells are known to hold nothing in it. Empty: nothing is known.
  std::span<const std::uint8_t> holds = {};

  float& at(int layer, int channel, int x) const {
    return plane[static_cast<std::size_t>(layer * channels + channel)][offset + x];
  }
  bool may_hold(int layer, int channel) const {
    return holds.empty() || holds[static_cast<std::size_t>(layer * channels + channel)] != 0;
  }
  /// Total amount of pigment in a layer of cell x.
  float total(int layer, int x) const {
    float sum = 0;
    for (int c = 0; c < channels; ++c) {
      const float m = amount[static_cast<std::size_t>(c)];
      if (m != 0) sum += m * at(layer, c, x);
    }
    return sum;
  }
  /// Highest layer of cell x that holds pigment; -1 if none does (A23).
  int top(int x) const {
    for (int layer = layers - 1; layer >= 0; --layer)
      if (total(layer, x) > kEmptyLayerAmount) return layer;
    return -1;
  }
};

/// The pigment planes of a state, from which rows are taken. Valid until a plane of the state is
/// replaced (a fluid scheme may swap planes); then call find() again.
class LayerPlanes {
 public:
  LayerPlanes(CanvasState& state, std::span<const float> amount);
  /// Looks the planes up again. The state has as many layers and channels as before. Allocates
  /// nothing.
  void find(CanvasState& state);
  /// Row y of the grid; cell 0 of the result is the grid's cell (x, y).
  LayerRow row(int x, int y) const;

 private:
  std::vector<float*> plane_;
  std::ptrdiff_t stride_ = 0;
  int layers_ = 1;
  int channels_ = 0;
  std::span<const float> amount_;
};

}  // namespace pentimento
