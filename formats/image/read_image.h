#pragma once
// Reads pictures: PNG, OpenEXR, JPEG and TIFF by their own libraries, Radiance HDR by our own code.
// The first bytes of a file decide what it is, not its name. Sizes are checked before memory is
// taken. A file that is damaged where its format shows it is an error; no library prints.

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

/// What samples of integer formats become. Samples of float formats are scene-linear and stay as
/// stored.
enum class SampleMeaning {
  kLight,  // linear light, in the picture's own primaries (alpha: stored value)
  kRaw     // the stored value, 0..1
};

struct ImageReadOptions {
  SampleMeaning meaning = SampleMeaning::kLight;
  ImageLimits limits;
};

/// A picture as planes of one size with names: "R","G","B" or "Y", "A" if there is one, and the
/// other channels of an EXR under their own names.
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

/// Converts linear light from the picture's own primaries to those of Rec. 709. Most pictures have
/// these already.
void to_rec709(Image& image);

/// Reads red, green and blue in linear light with Rec. 709 primaries. A grey picture gives three
/// equal planes. Errors: those of read_image(); kBadInput for an EXR without R, G, B or Y.
Result<std::array<Field<float>, 3>> read_rgb(const std::string& path,
                                             const ImageLimits& limits = {});

/// Reads a texture of heights or of grain: the stored values 0..1 without sRGB decoding. Of a
/// colour the mean is taken.
Result<Field<float>> read_grey(const std::string& path, const ImageLimits& limits = {});

/// Reads a brush tip, 1 = most paint: the alpha of a picture that has one, else the stored grey.
Result<Field<float>> read_tip(const std::string& path, const ImageLimits& limits = {});

}  // namespace pentimento
