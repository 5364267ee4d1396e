#include "formats/color/color_profile.h"

#include <cmath>

#include "core/base/approx.h"
#include "core/optics/srgb.h"

namespace pentimento {

namespace {

struct ProfileEntry {
  std::string_view name, title;
  Primaries primaries;
  double gamma;  // 0: the sRGB curve
};

constexpr double kAdobeGamma = 563.0 / 256;  // as the specification has it: 2.19921875

// In the order of ColorProfile.
constexpr std::array<ProfileEntry, 3> kEntries = {{
    {"srgb", "sRGB", {{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}}}, 0},
    {"display-p3", "Display P3", {{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}}}, 0},
    {"adobe-rgb", "Adobe RGB (1998)", {{{0.64, 0.33}, {0.21, 0.71}, {0.15, 0.06}}}, kAdobeGamma},
}};

const ProfileEntry& entry(ColorProfile profile) {
  return kEntries[static_cast<std::size_t>(profile)];
}

using Vector3 = std::array<double, 3>;

Vector3 xyz_of(const Chromaticity& c) {
  return {c[0] / c[1], 1, (1 - c[0] - c[1]) / c[1]};
}

ColorMatrix product(const ColorMatrix& a, const ColorMatrix& b) {
  ColorMatrix out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      out[i][j] = (a[i][0] * b[0][j] + a[i][1] * b[1][j]) + a[i][2] * b[2][j];
  return out;
}

/// By cofactors.
ColorMatrix inverse(const ColorMatrix& m) {
  ColorMatrix out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t r = (j + 1) % 3, s = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
      out[i][j] = m[r][c] * m[s][d] - m[r][d] * m[s][c];
    }
  const double determinant = (m[0][0] * out[0][0] + m[0][1] * out[1][0]) + m[0][2] * out[2][0];
  for (auto& row : out)
    for (double& v : row) v /= determinant;
  return out;
}

bool near(const Chromaticity& a, const Chromaticity& b) {
  constexpr double kPublishedDigits = 1e-3;
  return std::abs(a[0] - b[0]) <= kPublishedDigits && std::abs(a[1] - b[1]) <= kPublishedDigits;
}

}  // namespace

std::string_view profile_name(ColorProfile profile) {
  return entry(profile).name;
}

std::optional<ColorProfile> profile_named(std::string_view name) {
  for (const ColorProfile profile : kColorProfiles)
    if (profile_name(profile) == name) return profile;
  return std::nullopt;
}

std::string_view profile_title(ColorProfile profile) {
  return entry(profile).title;
}

const Primaries& primaries_of(ColorProfile profile) {
  return entry(profile).primaries;
}

std::optional<ColorProfile> profile_with(const Primaries& primaries, const Chromaticity& white) {
  for (const ColorProfile profile : kColorProfiles) {
    const Primaries& own = primaries_of(profile);
    if (near(white, kWhiteD65) && near(primaries[0], own[0]) && near(primaries[1], own[1]) &&
        near(primaries[2], own[2]))
      return profile;
  }
  return std::nullopt;
}

double decode_transfer(ColorProfile profile, double v) {
  const double gamma = entry(profile).gamma;
  if (gamma == 0) return srgb_to_linear(v);
  return v > 0 ? approx::pow(v, gamma) : 0;
}

double encode_transfer(ColorProfile profile, double v) {
  const double gamma = entry(profile).gamma;
  if (gamma == 0) return linear_to_srgb(v);
  return v > 0 ? approx::pow(v, 1 / gamma) : 0;
}

ColorMatrix to_xyz(ColorProfile profile) {
  const Primaries& primaries = primaries_of(profile);
  ColorMatrix columns{};
  for (std::size_t c = 0; c < 3; ++c) {
    const Vector3 xyz = xyz_of(primaries[c]);
    for (std::size_t i = 0; i < 3; ++i) columns[i][c] = xyz[i];
  }
  // Each primary is as strong as it must be for the three to make white.
  const ColorMatrix solve = inverse(columns);
  const Vector3 white = xyz_of(kWhiteD65);
  for (std::size_t c = 0; c < 3; ++c) {
    const double strength =
        (solve[c][0] * white[0] + solve[c][1] * white[1]) + solve[c][2] * white[2];
    for (std::size_t i = 0; i < 3; ++i) columns[i][c] *= strength;
  }
  return columns;
}

ColorMatrix from_xyz(ColorProfile profile) {
  return inverse(to_xyz(profile));
}

ColorMatrix between(ColorProfile from, ColorProfile to) {
  if (from == to) return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  return product(from_xyz(to), to_xyz(from));
}

}  // namespace pentimento
