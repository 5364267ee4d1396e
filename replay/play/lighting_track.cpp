#include "replay/play/lighting_track.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/optics/irradiance.h"
#include "core/optics/lamp.h"
#include "core/optics/tone.h"
#include "formats/image/read_image.h"
#include "formats/image/resample.h"

namespace pentimento {

namespace {
std::array<float, 3> to_float(const std::array<double, 3>& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}
Lamp dark_lamp() {
  Lamp lamp;
  lamp.intensity = 0;
  return lamp;
}
}  // namespace

std::array<float, 3> unit_direction(const std::array<double, 3>& v) {
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  if (!(length > 0)) return {0, 0, 1};
  return {static_cast<float>(v[0] / length), static_cast<float>(v[1] / length),
          static_cast<float>(v[2] / length)};
}

void develop(const log::PictureSpec& picture, Lighting& lighting) {
  if (picture.exposure_ev) lighting.exposure_ev = static_cast<float>(*picture.exposure_ev);
  if (picture.varnish) lighting.varnish = static_cast<float>(*picture.varnish);
  if (picture.occlusion) lighting.occlusion = static_cast<float>(*picture.occlusion);
  if (picture.white_temperature_K) {
    lighting.white_xy = white_of_temperature(*picture.white_temperature_K);
  }
  if (picture.white_xy) {
    lighting.white_xy = {static_cast<float>((*picture.white_xy)[0]),
                         static_cast<float>((*picture.white_xy)[1])};
  }
  if (picture.tone) lighting.tone = *picture.tone;
}

void fix_lamp(Lamp& lamp, const log::Gravity& gravity) {
  const std::array<float, 3> up = to_float({gravity.x_m_s2, gravity.y_m_s2, gravity.z_m_s2});
  lamp.direction = lamp_direction(lamp, up);
  if (lamp.position_m) lamp.position_m = lamp_position(lamp, up);
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

Result<void> light_by_panorama(const std::string& path, bool soft, Lighting& lighting) {
  // Finer is not told apart in the gloss of the smoothest paint: 0.7 degrees a pixel.
  constexpr int kMostWide = 512, kMostHigh = 256;
  Result<std::array<Field<float>, 3>> rgb = read_rgb(path);
  if (!rgb) return rgb.error();
  std::array<Field<float>, 3>& planes = *rgb;
  lighting.environment = project_panorama({planes[0].view(), planes[1].view(), planes[2].view()});
  lighting.probe = {};
  if (soft) return {};
  const int width = std::min(planes[0].width(), kMostWide);
  const int height = std::min(planes[0].height(), kMostHigh);
  for (std::size_t c = 0; c < 3; ++c)
    lighting.probe[c] = resample_area(planes[c].view(), width, height);
  return {};
}

Result<void> LightingTrack::follow(const log::Action& action, std::int64_t step, LogFiles& files) {
  if (const auto* gravity = std::get_if<log::Gravity>(&action)) {
    gravity_ = *gravity;
  } else if (const auto* event = std::get_if<log::Light>(&action)) {
    light(*event);
  } else if (const auto* around = std::get_if<log::Environment>(&action)) {
    return environment(*around, files);
  } else if (const auto* front = std::get_if<log::Camera>(&action)) {
    return camera(*front, step, files);
  }
  return {};
}

void LightingTrack::light(const log::Light& event) {
  const auto index = static_cast<std::size_t>(event.lamp);
  // Lamps with a lower number that no event has set yet are dark.
  while (lighting_.lamps.size() <= index) lighting_.lamps.push_back(dark_lamp());
  Lamp& lamp = lighting_.lamps[index];
  if (index > 0 && !event.intensity && lamp == dark_lamp()) lamp.intensity = Lamp{}.intensity;
  if (event.direction) {
    lamp.direction = unit_direction(*event.direction);
    lamp.position_m.reset();
  }
  if (event.position_m) lamp.position_m = to_float(*event.position_m);
  if (event.intensity) lamp.intensity = static_cast<float>(*event.intensity);
  if (event.color) lamp.color = to_float(*event.color);
  if (event.follow_gravity) {
    lamp.follows_gravity = true;
  } else if (event.direction || event.position_m) {
    lamp.follows_gravity = false;
  }
}

Result<void> LightingTrack::environment(const log::Environment& event, LogFiles& files) {
  if (event.sh) {
    for (std::size_t i = 0; i < 9; ++i) lighting_.environment.L[i] = to_float((*event.sh)[i]);
    lighting_.probe = {};
    return {};
  }
  Result<std::string> path = files.use(event.file);
  if (!path) return path.error();
  return light_by_panorama(*path, event.soft, lighting_);
}

Result<void> LightingTrack::camera(const log::Camera& event, std::int64_t step, LogFiles& files) {
  Result<std::string> path = files.use(event.file);
  if (!path) return path.error();
  lighting_.reflection.fov_deg = static_cast<float>(event.fov_deg);
  lighting_.reflection.mirror = event.mirror;
  video_.reset();
  if (is_video(*path)) {
    Result<std::unique_ptr<VideoReader>> reader = VideoReader::open(*path);
    if (!reader) return reader.error();
    video_ = {std::move(*reader), event.start_s, step};
    return {};
  }
  Result<std::array<Field<float>, 3>> rgb = read_rgb(*path);
  if (!rgb) return rgb.error();
  lighting_.reflection.rgb = std::move(*rgb);
  return {};
}

Result<void> LightingTrack::look(std::int64_t steps) {
  if (!video_) return {};
  Result<std::array<Field<float>, 3>> rgb =
      video_->reader->frame_at(video_->start_s + clock_.seconds(steps - video_->begun));
  if (!rgb) return rgb.error();
  lighting_.reflection.rgb = std::move(*rgb);
  return {};
}

}  // namespace pentimento
