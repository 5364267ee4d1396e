#include "core/canvas/canvas_state.h"

namespace pentimento {

namespace {
std::vector<Field<float>> clone_planes(const std::vector<Field<float>>& planes) {
  std::vector<Field<float>> copy;
  copy.reserve(planes.size());
  for (const Field<float>& plane : planes) copy.push_back(plane.clone());
  return copy;
}
}  // namespace

CanvasState make_canvas_state(const CanvasGeometry& geometry, int layers, int channels, int bands,
                              float white) {
  PENTIMENTO_CHECK(geometry.width > 0 && geometry.height > 0);
  PENTIMENTO_CHECK(layers >= 1 && layers <= 8 && channels >= 0 && bands >= 1);
  constexpr int kOthers = 6;  // planes besides those of bands and channels
  PlaneMemory memory(kOthers + bands + layers * channels, geometry.width, geometry.height);
  const auto plane = [&](float value) {
    Field<float> made(geometry.width, geometry.height, memory);
    if (value != 0) made.fill(value);
    return made;
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
  s.stroke = Field<std::uint32_t>(geometry.width, geometry.height, memory);
  return s;
}

CanvasState clone_state(const CanvasState& state) {
  CanvasState copy;
  copy.geometry = state.geometry;
  copy.layers = state.layers;
  copy.channels = state.channels;
  copy.bands = state.bands;
  copy.depth_m = state.depth_m.clone();
  copy.velocity_x_m_s = state.velocity_x_m_s.clone();
  copy.velocity_y_m_s = state.velocity_y_m_s.clone();
  copy.base_m = state.base_m.clone();
  copy.paper_m = state.paper_m.clone();
  copy.reflectance = clone_planes(state.reflectance);
  copy.pigment = clone_planes(state.pigment);
  copy.stroke = state.stroke.clone();
  copy.step = state.step;
  copy.sleep = state.sleep;
  return copy;
}

}  // namespace pentimento
