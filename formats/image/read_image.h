#pragma once
// Pictures in: PNG and OpenEXR by their own libraries, everything else (Radiance HDR, JPEG, TIFF)
// through a module that is loaded when the first such file is read. What a file is follows from its
// first bytes, not from its name. Sizes are checked before memory is taken.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/field.h"
#include "core/base/result.h"
#include "formats/color/color_profile.h"

namespace pentimento {

struct ImageLimits {
  int max_side = 65536;
  std::int64_t max_pixels = std::int64_t{1} << 27;
};

/// What the samples of integer formats become; float formats are scene-linear and stay as stored.
enum class SampleMeaning {
  kLight,  // linear light, in the picture's own primaries (alpha: stored value)
  kRaw     // the stored value, 0..1
};

struct ImageReadOptions {
  SampleMeaning meaning = SampleMeaning::kLight;
  ImageLimits limits;
};

/// Planes of one size with their names: "R","G","B" or "Y", "A" if there is one, and whatever else
/// an EXR holds under the names it gives.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::string> name;
  std::vector<Field<float>> plane;
  std::string format;         // "png", "exr", "hdr", "jpeg", "tiff"
  int bits = 8;               // of a stored sample
  bool stored_float = false;  // half or float samples
  // Whose primaries (and, of integers, curve) the samples have. Pictures that say nothing, or what
  // we do not know, are taken for sRGB; `profile_title` is what they say, empty if nothing.
  ColorProfile profile = ColorProfile::kSrgb;
  std::string profile_title;
  bool unknown_profile = false;  // it says one that we do not know

  /// nullptr if there is none of that name.
  const Field<float>* find(const std::string& plane_name) const;
};

/// Errors: kIo (cannot be read), kLimit (larger than the limits), kBadInput (not a picture, or a
/// broken one).
Result<Image> read_image(const std::string& path, const ImageReadOptions& options = {});

/// Linear light in the picture's own primaries to that of Rec. 709; nothing to do for most.
void to_rec709(Image& image);

/// Red, green and blue in linear light, Rec. 709 primaries; a grey picture gives three equal
/// planes. Errors: as read_image; kBadInput for an EXR without R, G, B or Y.
Result<std::array<Field<float>, 3>> read_rgb(const std::string& path,
                                             const ImageLimits& limits = {});

/// A height or grain texture: stored values 0..1 without sRGB decoding; colours are averaged.
Result<Field<float>> read_grey(const std::string& path, const ImageLimits& limits = {});

/// A brush tip, 1 = most paint: the alpha of pictures that have one, else 1 - grey (tips are drawn
/// dark on white).
Result<Field<float>> read_tip(const std::string& path, const ImageLimits& limits = {});

}  // namespace pentimento
