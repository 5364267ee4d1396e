#pragma once
// The files that a log's header names: tips of brushes, and the picture of the paper. They are
// opened before any work, by `validate` as by `render`.

#include "core/base/result.h"
#include "formats/log/tables/events.h"
#include "replay/log/brushes.h"
#include "replay/log/log_files.h"

namespace pentimento {

/// Reads the tips of the header's brushes, and sees that the picture of its paper can be read.
/// Errors: those of the files, with the log's name and line.
Result<BrushTable> open_header_files(const log::Header& header, LogFiles& files);

}  // namespace pentimento
