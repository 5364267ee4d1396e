#pragma once
// The brushes of Tilt Brush that a painting can name, and what of them matters here.

#include <optional>
#include <string_view>

#include "formats/import/sketch/sketch.h"

namespace pentimento::sketch {

struct TiltBrush {
  std::string_view guid, name;
  std::optional<double> width_share_unpressed;  // of the width, at no pressure; 0..1
};

/// The brush of a GUID in small letters; nothing if it is not known. Source: the assets of
/// github.com/googlevr/tilt-brush (Apache-2.0), 135 brushes.
std::optional<TiltBrush> tilt_brush(std::string_view guid);

/// The built-in brush that comes nearest, by the name's words.
BrushKind kind_of_tilt_brush(std::string_view name);

}  // namespace pentimento::sketch
