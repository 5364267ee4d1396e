#include "core/layers/layer_row.h"

namespace pentimento {

LayerPlanes::LayerPlanes(CanvasState& state, std::span<const float> amount)
    : plane_(state.pigment.size()),
      layers_(state.layers),
      channels_(state.channels),
      amount_(amount) {
  PENTIMENTO_CHECK(layers_ >= 1 && layers_ <= kMaxLayers);
  PENTIMENTO_CHECK(static_cast<int>(amount.size()) == channels_);
  find(state);
}

void LayerPlanes::find(CanvasState& state) {
  PENTIMENTO_CHECK(state.pigment.size() == plane_.size());
  for (std::size_t i = 0; i < plane_.size(); ++i) {
    plane_[i] = state.pigment[i].row(0);
    stride_ = state.pigment[i].view().stride();
  }
}

LayerRow LayerPlanes::row(int x, int y) const {
  return {plane_, stride_ * y + x, layers_, channels_, amount_, {}};
}

}  // namespace pentimento
