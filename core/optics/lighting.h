#pragma once
// What lights a picture (R29, R32-R34). Directions here are in the viewer's frame: x right, y UP,
// z out of the canvas towards the viewer, as logs and sensors have it.

#include <array>
#include <optional>
#include <vector>

#include "core/base/field.h"

namespace pentimento {

/// Nine RGB radiance coefficients, order L00 L1-1 L10 L11 L2-2 L2-1 L20 L21 L22 (RH01).
struct ShCoefficients {
  std::array<std::array<float, 3>, 9> L{};
};

/// The default environment: a pale room with one broad soft source at the upper left. Radiance
/// 0.28 + 0.20 (d . s), s = (-.45, .55, .70), a little cooler than the lamp. Strength chosen by eye
/// together with the default lamp, so that bare linen is white without a burnt thread
/// (docs/optics.md).
inline constexpr ShCoefficients kStudioEnvironment{{{{0.976f, 0.985f, 1.005f},
                                                     {0.222f, 0.224f, 0.228f},
                                                     {0.282f, 0.285f, 0.290f},
                                                     {-0.181f, -0.183f, -0.186f},
                                                     {},
                                                     {},
                                                     {},
                                                     {},
                                                     {}}}};

/// One lamp, far away or near. `direction` points towards it, unit length. `position_m`, if set,
/// is counted from the canvas's centre and takes the direction's place; `intensity` is then that
/// at the centre, and falls with the square of the distance.
struct Lamp {
  std::array<float, 3> direction = {-0.48f, 0.60f, 0.64f};  // top left
  std::optional<std::array<float, 3>> position_m;
  float intensity = 0.75f;  // irradiance at normal incidence / pi
  std::array<float, 3> color = {1.0f, 0.976f, 0.94f};
  bool follows_gravity = false;  // fixed in the room: turns against the tablet (lamp.h)
  friend bool operator==(const Lamp&, const Lamp&) = default;
};

/// The front camera's picture (R34), linear RGB, row 0 on top; empty = reflect the SH light.
/// `mirror`: the picture is as the camera sees it, so what is at the viewer's right lies in its
/// left half; false: already mirrored, as cameras show it to who stands before them.
struct ReflectionMap {
  std::array<Field<float>, 3> rgb;
  float fov_deg = 60;  // horizontal
  bool mirror = true;
};

/// A light probe as the gloss of paint shows it (gloss_table.h): an equirectangular panorama,
/// linear RGB, row 0 on top; empty = the gloss shows the nine harmonics of the environment.
using LightProbe = std::array<Field<float>, 3>;

inline constexpr int kMostLamps = 7;

/// How scene-linear light becomes the values of a display (tone.h).
enum class ToneCurve { kNone, kSoft, kFilmic };
/// CIE xy of D65, sRGB's white.
inline constexpr std::array<float, 2> kD65_xy = {0.3127f, 0.3290f};

struct Lighting {
  std::vector<Lamp> lamps = std::vector<Lamp>(1);  // 1 to kMostLamps; the first is the lamp
  ShCoefficients environment = kStudioEnvironment;
  LightProbe probe;  // that the harmonics were made of
  ReflectionMap reflection;
  float roughness_wet = 0.16f;  // Beckmann a; by eye (docs/optics.md)
  float roughness_dry = 0.45f;
  float refractive_index = 1.48f;
  float varnish = 0;          // 0..1: a smooth clear coat over everything
  float relief_scale = 1.0f;  // of the height for normals (A34)
  float occlusion = 1.0f;     // 0..1: how much relief hides of sky and lamps; 0 = not searched
  float exposure_ev = 0;      // picture = linear x 2^exposure
  std::array<float, 2> white_xy = kD65_xy;  // of the light that becomes white
  ToneCurve tone = ToneCurve::kNone;        // of pictures for a display; EXR stays linear
};

}  // namespace pentimento
