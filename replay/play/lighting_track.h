#pragma once
// Follows the light through the log's events: lamps, environment, the front camera's picture. For
// pictures only; nothing here reaches the state.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "core/base/result.h"
#include "core/optics/lighting.h"
#include "formats/log/tables/events.h"
#include "formats/video/video_reader.h"
#include "replay/job/step_clock.h"
#include "replay/log/log_files.h"

namespace pentimento {

/// The light before any event: the lamp of Lighting at the top left and an even, slightly cool room
/// light from above.
Lighting default_lighting();

/// Puts a panorama's light (a file: equirectangular, HDR, EXR or any picture) into `lighting`: its
/// nine coefficients and, unless it is `soft`, what the gloss shows of it, at most 512 x 256.
/// Errors: those of the file.
Result<void> light_by_panorama(const std::string& path, bool soft, Lighting& lighting);

/// A direction of a log or command line at unit length; (0,0,1) if it has none.
std::array<float, 3> unit_direction(const std::array<double, 3>& direction);

/// What a log's header says about its pictures, put into `lighting`.
void develop(const log::PictureSpec& picture, Lighting& lighting);

/// Gives a lamp that follows gravity the direction that it has under `gravity`, as a fixed lamp.
void fix_lamp(Lamp& lamp, const log::Gravity& gravity);

class LightingTrack {
 public:
  LightingTrack(Lighting start, double steps_per_second)
      : lighting_(std::move(start)), clock_(steps_per_second) {}

  /// Follows `light`, `environment`, `camera` and `gravity` events of the step `step`; others are
  /// ignored. Errors: those of the files.
  Result<void> follow(const log::Action& action, std::int64_t step, LogFiles& files);

  /// If the front camera recorded a video, puts the frame after `steps` steps into lighting(). A
  /// still picture stays as it is. Errors: those of the video.
  Result<void> look(std::int64_t steps);

  /// The light as the events set it. Lamps that follow gravity are not turned yet.
  const Lighting& lighting() const { return lighting_; }
  /// The accelerometer's last reading.
  const log::Gravity& gravity() const { return gravity_; }

 private:
  void light(const log::Light& event);
  Result<void> environment(const log::Environment& event, LogFiles& files);
  Result<void> camera(const log::Camera& event, std::int64_t step, LogFiles& files);

  /// A video that the front camera recorded.
  struct CameraVideo {
    std::unique_ptr<VideoReader> reader;
    double start_s = 0;      // of it, when the event happened
    std::int64_t begun = 0;  // step of the event
  };
  Lighting lighting_;
  StepClock clock_;
  std::optional<CameraVideo> video_;
  log::Gravity gravity_;
};

}  // namespace pentimento
