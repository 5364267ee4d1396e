#pragma once
// The colour spaces that pictures are written in. All have the white point D65, so light goes from
// one to the other by a matrix alone. Only + - * / sqrt: a picture loaded onto the canvas gives the
// same bits on every machine.
// Sources: IEC 61966-2-1 (sRGB); SMPTE EG 432-1 with the sRGB curve (Display P3); Adobe RGB (1998)
// Color Image Encoding, 2005.

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace pentimento {

enum class ColorProfile { kSrgb, kDisplayP3, kAdobeRgb };

inline constexpr std::array<ColorProfile, 3> kColorProfiles = {
    ColorProfile::kSrgb, ColorProfile::kDisplayP3, ColorProfile::kAdobeRgb};

/// CIE 1931 x, y.
using Chromaticity = std::array<double, 2>;
/// Chromaticities of red, green and blue.
using Primaries = std::array<Chromaticity, 3>;
/// Row by row.
using ColorMatrix = std::array<std::array<double, 3>, 3>;

inline constexpr Chromaticity kWhiteD65 = {0.3127, 0.3290};

/// The name on the command line: "srgb", "display-p3" or "adobe-rgb".
std::string_view profile_name(ColorProfile profile);
std::optional<ColorProfile> profile_named(std::string_view name);
/// The name for people: "sRGB", "Display P3" or "Adobe RGB (1998)".
std::string_view profile_title(ColorProfile profile);

const Primaries& primaries_of(ColorProfile profile);
/// The profile that has these primaries and the white D65, each coordinate within 0.001 (the
/// published digits). nullopt if there is none.
std::optional<ColorProfile> profile_with(const Primaries& primaries, const Chromaticity& white);

/// Linear light of the encoded value `v` in [0,1]; relative error below 1e-14.
double decode_transfer(ColorProfile profile, double v);
/// Encoded value of the linear light `v` in [0,1]; relative error below 1e-14.
double encode_transfer(ColorProfile profile, double v);

/// The matrix from linear RGB of `profile` to CIE XYZ, with Y = 1 for white. Its second row has the
/// weights of luminance.
ColorMatrix to_xyz(ColorProfile profile);
/// The other way round.
ColorMatrix from_xyz(ColorProfile profile);
/// The matrix from linear RGB of `from` to that of `to`; exactly the identity if both are the same.
ColorMatrix between(ColorProfile from, ColorProfile to);

}  // namespace pentimento
