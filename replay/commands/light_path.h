#pragma once
// The path of the first lamp through the frames of `relight --light-path`.

#include <array>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/optics/lighting.h"

namespace pentimento {

/// The places of the lamp, one for each frame: positions if `start` has one, else directions. If
/// `path` is `orbit`, the lamp goes once around the canvas's normal, anticlockwise from where it
/// stands, and the last frame is one step before the first. Otherwise `path` is a text file with a
/// point `X Y Z` on each line (spaces or commas; `#` begins a comment). The first frame is at the
/// first point, the last at the last, the others evenly between. Errors: kIo; kBadInput with file
/// and line; kUsage for less than one frame.
Result<std::vector<std::array<float, 3>>> light_path(const std::string& path, int frames,
                                                     const Lamp& start);

}  // namespace pentimento
