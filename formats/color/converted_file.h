#pragma once
// A picture file that takes scene-linear light with Rec. 709 primaries and stores the light with
// the primaries of another profile.

#include <memory>
#include <string>
#include <vector>

#include "formats/color/color_profile.h"
#include "formats/io/picture_file.h"

namespace pentimento {

/// The indices of the channels that hold light, in threes: "R","G","B", and "a.R","a.G","a.B" of
/// every layer.
std::vector<std::array<std::size_t, 3>> light_channels(const std::vector<std::string>& names);

/// Hands strips on to `file` with their light in the primaries of `profile`. Nothing is clipped;
/// negative values stay. `channels`: the names of the strips' planes. Returns `file` itself for
/// sRGB.
std::unique_ptr<PictureFile> convert_light(std::unique_ptr<PictureFile> file, ColorProfile profile,
                                           const std::vector<std::string>& channels, int threads);

}  // namespace pentimento
