#pragma once
// What lights a picture (R29, R32-R34). Directions here are in the viewer's frame: x right, y UP,
// z out of the canvas towards the viewer, as logs and sensors have it.

#include <array>
#include <string>

#include "core/field.h"

namespace pentimento {

/// Nine RGB radiance coefficients, order L00 L1-1 L10 L11 L2-2 L2-1 L20 L21 L22 (model.md II.3).
struct ShCoefficients {
  std::array<std::array<float, 3>, 9> L{};
};

/// One directional lamp. `direction` points towards the lamp, unit length.
struct Lamp {
  std::array<float, 3> direction = {-0.48f, 0.60f, 0.64f};  // top left
  float intensity = 1.0f;                                   // irradiance at normal incidence / pi
  std::array<float, 3> color = {1, 1, 1};
  bool follows_gravity = false;  // fixed in the room: turns against the tablet (A31)
};

/// The front camera's picture (R34), linear RGB, row 0 on top; empty = reflect the SH light.
struct ReflectionMap {
  std::array<Field<float>, 3> rgb;
  float fov_deg = 60;  // horizontal
  bool mirror = true;
};

struct Lighting {
  Lamp lamp;
  ShCoefficients environment;
  ReflectionMap reflection;
  float roughness_wet = 0.25f;  // Beckmann a
  float roughness_dry = 0.45f;
  float refractive_index = 1.48f;
  float relief_scale = 1.0f;  // of the height for normals (A34)
  float exposure_ev = 0;      // picture = linear x 2^exposure
};

}  // namespace pentimento
