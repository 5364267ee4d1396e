#pragma once
// What the file `metadata.json` of a `.tilt` says of a painting: its brushes, the camera of its
// thumbnail, its background.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "formats/import/space/camera.h"
#include "formats/import/space/tilt_brushes.h"

namespace pentimento::sketch {

struct TiltScene {
  std::vector<TiltBrush> brushes;       // those that are not known have the GUID as name
  std::optional<PinholeCamera> camera;  // in decimetres of the strokes, right-handed, aspect 1
  std::optional<log::Rgb> background;   // linear light
  std::string title, author;
};

/// Errors: kBadInput "NAME: metadata.json: what".
Result<TiltScene> read_tilt_scene(const std::string& name, std::string_view json);

}  // namespace pentimento::sketch
