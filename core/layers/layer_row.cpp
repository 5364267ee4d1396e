#include "core/layers/layer_row.h"

namespace pentimento {

LayerPlanes::LayerPlanes(CanvasState& state, std::span<const float> amount)
    : layers_(state.layers), channels_(state.channels), amount_(amount) {
  PENTIMENTO_CHECK(layers_ >= 1 && layers_ <= kMaxLayers);
  PENTIMENTO_CHECK(static_cast<int>(amount.size()) == channels_);
  for (Field<float>& plane : state.pigment) {
    plane_.push_back(plane.row(0));
    stride_ = plane.view().stride();
  }
}

LayerRow LayerPlanes::row(int x, int y) const {
  return {plane_, stride_ * y + x, layers_, channels_, amount_};
}

}  // namespace pentimento
