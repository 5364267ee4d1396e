#pragma once
// The size that a TIFF says it has, before a library takes memory for it. Internal to formats.

#include <string>

#include "core/base/result.h"
#include "formats/image/read_image.h"

namespace pentimento::image {

/// Looks at every width and height in the first directory of a TIFF. Errors: kLimit for a size
/// beyond the limits, kBadInput for a directory that is not whole or says no size
/// (0 x 0 pixels), kIo.
Result<void> check_tiff_header(const std::string& path, const ImageLimits& limits);

}  // namespace pentimento::image
