#include "replay/play/copies.h"

namespace pentimento {

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
