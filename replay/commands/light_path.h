#pragma once
// The way of the first lamp through the frames of `relight --light-path`.

#include <array>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/optics/lighting.h"

namespace pentimento {

/// Places of the lamp, one a frame: directions, or positions if the lamp has one.
/// `orbit`: once around the canvas's normal from where the lamp stands, against the clock, the last
/// frame one step before the first. Otherwise a text file, a point `X Y Z` a line (spaces or
/// commas; `#` begins a comment): the first frame at its first point, the last at its last, evenly
/// between. Errors: kIo; kBadInput with file and line; kUsage for less than one frame.
Result<std::vector<std::array<float, 3>>> light_path(const std::string& path, int frames,
                                                     const Lamp& start);

/// `pattern` with the number of the frame in place of its `%d` or `%04d`. Errors: kUsage if there
/// is none, or more.
Result<std::string> frame_name(const std::string& pattern, int frame);

}  // namespace pentimento
