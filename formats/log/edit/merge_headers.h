#pragma once
// Two logs of one canvas need one header.

#include "core/base/result.h"
#include "formats/log/tables/events.h"

namespace pentimento::log {

/// Takes pigments and brushes of `other` into `header`, which keeps all else. Errors: kBadInput
/// (another canvas, other `steps_per_second`, or a name that means something else in each).
Result<void> merge_headers(Header& header, const Header& other);

}  // namespace pentimento::log
