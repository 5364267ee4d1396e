#pragma once
// A sketch becomes an action log.

#include <cstdint>
#include <string>

#include "core/base/result.h"
#include "formats/import/sketch/sketch.h"
#include "formats/log/write/writer.h"

namespace pentimento::sketch {

struct LogOptions {
  int cells = 1024;             // of the grid's longer side
  double longest_pause_s = 10;  // longer ones are cut to this; wet paint rests by then
};

/// Where the sketch comes from; goes into the log's header as `x-source`.
struct SketchOrigin {
  std::string format, file, sha256;
};

struct LogCounts {
  std::int64_t strokes = 0, samples = 0, events = 0;
  double duration_s = 0;
  double canvas_width_m = 0, canvas_height_m = 0;
  Report report;  // the sketch's, and what became of its times
};

/// Writes header and events. Errors: kBadInput (a
/// drawing of no size), kLimit (more than 64 strokes at once).
Result<LogCounts> write_log(const Sketch& sketch, const SketchOrigin& origin,
                            const LogOptions& options, log::Writer& writer);

}  // namespace pentimento::sketch
