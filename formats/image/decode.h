#pragma once
// One decoder per kind of picture file; read_image() chooses. Internal to formats.

#include <string>

#include "core/base/result.h"
#include "formats/image/read_image.h"

namespace pentimento::image {

Result<Image> decode_png(const std::string& path, const ImageReadOptions& options);
Result<Image> decode_exr(const std::string& path, const ImageReadOptions& options);
/// Radiance HDR.
Result<Image> decode_hdr(const std::string& path, const ImageReadOptions& options);
Result<Image> decode_jpeg(const std::string& path, const ImageReadOptions& options);
Result<Image> decode_tiff(const std::string& path, const ImageReadOptions& options);

/// Errors: kLimit for a picture beyond the limits, kBadInput for a size that is not positive.
Result<void> check_size(const std::string& path, std::int64_t width, std::int64_t height,
                        const ImageLimits& limits);

}  // namespace pentimento::image
