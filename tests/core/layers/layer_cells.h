#pragma once
// A row of hand-made cells for the tests of the layer kernels.

#include <vector>

#include "core/layers/layer_row.h"

namespace pentimento {

/// `layers` x `channels` planes of `cells` cells, all 0, every channel a pigment.
class LayerCells {
 public:
  LayerCells(int layers, int channels, int cells = 1)
      : state_(make_canvas_state({cells, 1, 1, 1}, layers, channels, 3, 1)),
        amount_(static_cast<std::size_t>(channels), 1.0f),
        planes_(state_, amount_) {}
  LayerRow row() { return planes_.row(0, 0); }
  CanvasState& state() { return state_; }
  /// Sets channel `c` of cell 0, bottom layer first.
  void set(int c, const std::vector<float>& amounts) {
    for (std::size_t k = 0; k < amounts.size(); ++k)
      state_.channel(static_cast<int>(k), c)(0, 0) = amounts[k];
  }
  std::vector<float> get(int c, int x = 0) const {
    std::vector<float> out;
    for (int k = 0; k < state_.layers; ++k) out.push_back(state_.channel(k, c)(x, 0));
    return out;
  }

 private:
  CanvasState state_;
  std::vector<float> amount_;
  LayerPlanes planes_;
};

}  // namespace pentimento
