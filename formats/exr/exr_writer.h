#pragma once
// Writes OpenEXR: scene-linear light in half or float, AOV layers, chromaticities, xDensity,
// provenance as attributes. The file is streamed and published atomically. Large pictures are
// tiled, so that programs can show a part without reading the rest.

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "formats/color/color_profile.h"
#include "formats/io/picture_file.h"

namespace pentimento {

struct ExrOptions {
  int width = 0, height = 0;
  bool full_float = false;
  double dpi = 0;                     // pixels an inch, the attribute xDensity; 0: not told
  std::vector<std::string> channels;  // in the order of the strips' planes: R, G, B, AOVs
  Provenance provenance;
  int threads = 1;
  bool no_clobber = false;
  ColorProfile profile = ColorProfile::kSrgb;  // whose primaries the file's light has
};

/// Pictures with a longer side are written in tiles of 256 x 256 pixels.
inline constexpr int kLongestScanlineSide = 8192;

/// Errors: kIo (not writable, or it exists and `no_clobber`).
Result<std::unique_ptr<PictureFile>> create_exr(const std::string& path, const ExrOptions& options);

}  // namespace pentimento
