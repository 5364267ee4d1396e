#pragma once
// The strokes of Tilt Brush's and Open Brush's paintings: the file `data.sketch` in a `.tilt`.

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "formats/import/space/space_stroke.h"
#include "formats/import/space/tilt_brushes.h"

namespace pentimento::sketch {

/// Strokes in decimetres, right-handed (the file's z is turned round), in the order of the file.
/// `brushes` are those that the painting names; strokes refer to them by their places. Errors:
/// kBadInput "NAME: offset N: what".
Result<std::vector<SpaceStroke>> read_tilt_strokes(const std::string& name, std::string_view bytes,
                                                   const std::vector<TiltBrush>& brushes);

}  // namespace pentimento::sketch
