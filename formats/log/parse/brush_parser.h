#pragma once
// One brush of a log's header.

#include "formats/log/parse/fields.h"
#include "formats/log/tables/events.h"

namespace pentimento::log {

/// Reads a brush. `fields` keeps the first problem.
BrushSpec parse_brush_spec(Fields& fields);

}  // namespace pentimento::log
