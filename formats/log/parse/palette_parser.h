#pragma once
// The palette and the brushes of a header.

#include "formats/log/parse/fields.h"
#include "formats/log/tables/events.h"

namespace pentimento::log {

/// Reads `palette` out of a header; problems are noted in `header`.
std::vector<PigmentSpec> parse_palette(Fields& header);
/// Reads `brushes` out of a header; problems are noted in `header`.
std::vector<BrushSpec> parse_brushes(Fields& header);

}  // namespace pentimento::log
