#include "replay/lighting_track.h"

#include <array>
#include <cmath>
#include <utility>

#include "core/optics/irradiance.h"
#include "core/optics/lamp.h"
#include "formats/image/read_image.h"

namespace pentimento {

namespace {
std::array<float, 3> to_float(const std::array<double, 3>& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}
}  // namespace

std::array<float, 3> unit_direction(const std::array<double, 3>& v) {
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  if (!(length > 0)) return {0, 0, 1};
  return {static_cast<float>(v[0] / length), static_cast<float>(v[1] / length),
          static_cast<float>(v[2] / length)};
}

void settle_lamp(Lamp& lamp, const log::Gravity& gravity) {
  lamp.direction = lamp_direction(lamp, to_float({gravity.x_m_s2, gravity.y_m_s2, gravity.z_m_s2}));
  lamp.follows_gravity = false;
}

Lighting default_lighting() {
  // Radiance 0.45 all around and a little more from above: white lit by it and by the lamp comes
  // out just below 1.
  constexpr float kL00 = 3.5449077f;  // of radiance 1 all around
  constexpr float kRadiance = 0.45f;
  Lighting lighting;
  for (std::size_t c = 0; c < 3; ++c) {
    constexpr std::array<float, 3> kTint = {0.98f, 1.0f, 1.03f};
    lighting.environment.L[0][c] = kL00 * kRadiance * kTint[c];
    lighting.environment.L[1][c] = 0.2f * kL00 * kRadiance * kTint[c];
  }
  return lighting;
}

Result<ShCoefficients> read_environment(const std::string& path) {
  Result<std::array<Field<float>, 3>> rgb = read_rgb(path);
  if (!rgb) return rgb.error();
  const std::array<Field<float>, 3>& planes = *rgb;
  return project_panorama({planes[0].view(), planes[1].view(), planes[2].view()});
}

Result<void> LightingTrack::follow(const log::Action& action, LogFiles& files) {
  if (const auto* gravity = std::get_if<log::Gravity>(&action)) {
    gravity_ = *gravity;
  } else if (const auto* event = std::get_if<log::Light>(&action)) {
    light(*event);
  } else if (const auto* around = std::get_if<log::Environment>(&action)) {
    return environment(*around, files);
  } else if (const auto* front = std::get_if<log::Camera>(&action)) {
    return camera(*front, files);
  }
  return {};
}

void LightingTrack::light(const log::Light& event) {
  Lamp& lamp = lighting_.lamp;
  if (event.direction) lamp.direction = unit_direction(*event.direction);
  if (event.intensity) lamp.intensity = static_cast<float>(*event.intensity);
  if (event.color) lamp.color = to_float(*event.color);
  if (event.follow_gravity) {
    lamp.follows_gravity = true;
  } else if (event.direction) {
    lamp.follows_gravity = false;
  }
}

Result<void> LightingTrack::environment(const log::Environment& event, LogFiles& files) {
  if (event.sh) {
    for (std::size_t i = 0; i < 9; ++i) lighting_.environment.L[i] = to_float((*event.sh)[i]);
    return {};
  }
  Result<std::string> path = files.use(event.file);
  if (!path) return path.error();
  Result<ShCoefficients> coefficients = read_environment(*path);
  if (!coefficients) return coefficients.error();
  lighting_.environment = *coefficients;
  return {};
}

Result<void> LightingTrack::camera(const log::Camera& event, LogFiles& files) {
  Result<std::string> path = files.use(event.file);
  if (!path) return path.error();
  Result<std::array<Field<float>, 3>> rgb = read_rgb(*path);
  if (!rgb) return rgb.error();
  lighting_.reflection.rgb = std::move(*rgb);
  lighting_.reflection.fov_deg = static_cast<float>(event.fov_deg);
  lighting_.reflection.mirror = event.mirror;
  return {};
}

}  // namespace pentimento
