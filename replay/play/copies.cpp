#include "replay/play/copies.h"

namespace pentimento {

namespace {
std::vector<Field<float>> clone_planes(const std::vector<Field<float>>& planes) {
  std::vector<Field<float>> copy;
  copy.reserve(planes.size());
  for (const Field<float>& plane : planes) copy.push_back(plane.clone());
  return copy;
}
}  // namespace

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

Lighting clone_lighting(const Lighting& lighting) {
  Lighting copy;
  copy.lamps = lighting.lamps;
  copy.environment = lighting.environment;
  for (std::size_t c = 0; c < 3; ++c) copy.reflection.rgb[c] = lighting.reflection.rgb[c].clone();
  for (std::size_t c = 0; c < 3; ++c) copy.probe[c] = lighting.probe[c].clone();
  copy.reflection.fov_deg = lighting.reflection.fov_deg;
  copy.reflection.mirror = lighting.reflection.mirror;
  copy.roughness_wet = lighting.roughness_wet;
  copy.roughness_dry = lighting.roughness_dry;
  copy.refractive_index = lighting.refractive_index;
  copy.relief_scale = lighting.relief_scale;
  copy.varnish = lighting.varnish;
  copy.occlusion = lighting.occlusion;
  copy.exposure_ev = lighting.exposure_ev;
  copy.white_xy = lighting.white_xy;
  copy.tone = lighting.tone;
  return copy;
}

}  // namespace pentimento
