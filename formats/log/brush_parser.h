#pragma once
// One brush of a log's header.

#include "formats/log/events.h"
#include "formats/log/fields.h"

namespace pentimento::log {

/// Problems are noted in `fields`.
BrushSpec parse_brush_spec(Fields& fields);

}  // namespace pentimento::log
