#include "core/canvas/canvas_state.h"

namespace pentimento {

CanvasState make_canvas_state(const CanvasGeometry& geometry, int layers, int channels, int bands,
                              float white) {
  PENTIMENTO_CHECK(geometry.width > 0 && geometry.height > 0);
  PENTIMENTO_CHECK(layers >= 1 && layers <= 8 && channels >= 0 && bands >= 1);
  const auto plane = [&](float value) {
    return Field<float>(geometry.width, geometry.height, value);
  };
  CanvasState s;
  s.geometry = geometry;
  s.layers = layers;
  s.channels = channels;
  s.bands = bands;
  s.depth_m = plane(0);
  s.velocity_x_m_s = plane(0);
  s.velocity_y_m_s = plane(0);
  s.base_m = plane(0);
  s.paper_m = plane(0);
  for (int b = 0; b < bands; ++b) s.reflectance.push_back(plane(white));
  for (int i = 0; i < layers * channels; ++i) s.pigment.push_back(plane(0));
  s.stroke = Field<std::uint32_t>(geometry.width, geometry.height);
  return s;
}

}  // namespace pentimento
