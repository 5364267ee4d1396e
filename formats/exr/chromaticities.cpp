#include "formats/exr/chromaticities.h"

#include <ImfStandardAttributes.h>

namespace pentimento::exr {

namespace {
Imath::V2f to_vector(const Chromaticity& c) {
  return {static_cast<float>(c[0]), static_cast<float>(c[1])};
}
Chromaticity from_vector(const Imath::V2f& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y)};
}
}  // namespace

Imf::Chromaticities chromaticities_of(ColorProfile profile) {
  const Primaries& p = primaries_of(profile);
  return {to_vector(p[0]), to_vector(p[1]), to_vector(p[2]), to_vector(kWhiteD65)};
}

std::optional<ColorProfile> profile_in(const Imf::Header& header) {
  if (!Imf::hasChromaticities(header)) return std::nullopt;
  const Imf::Chromaticities& c = Imf::chromaticities(header);
  return profile_with({from_vector(c.red), from_vector(c.green), from_vector(c.blue)},
                      from_vector(c.white));
}

}  // namespace pentimento::exr
