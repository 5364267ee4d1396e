#pragma once
// ICC profiles, by LittleCMS: made for the files that we write, recognised in the files that we
// read.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "formats/color/color_profile.h"

namespace pentimento {

/// A matrix and curve profile (ICC.1, version 4.3): D65 adapted to D50 by Bradford, the curves as
/// parameters. It names no date, so the same version of LittleCMS always gives the same bytes.
std::vector<std::uint8_t> icc_profile(ColorProfile profile);

/// What a profile of any origin says.
struct IccDescription {
  std::string title;                    // its own description; may be empty
  std::optional<ColorProfile> profile;  // one that we know: same primaries (XYZ within 0.002) and
                                        // curves (within 0.003 everywhere)
};

/// nullopt if these bytes are no RGB profile.
std::optional<IccDescription> describe_icc(std::span<const std::uint8_t> bytes);

}  // namespace pentimento
