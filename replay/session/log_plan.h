#pragma once
// The plan of a replay: what must be known of a log before it is played. It says which strokes are
// undone, the palette, how long the log is and where to stop, and it makes sure that the files are
// there. One pass over the log finds it; the plan keeps a few bytes per stroke and nothing per
// sample.

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "formats/log/reader.h"
#include "replay/job/control.h"
#include "replay/job/stop_points.h"
#include "replay/log/log_files.h"
#include "replay/log/palette.h"
#include "replay/timeline/stamp_budget.h"
#include "replay/timeline/undo.h"

namespace pentimento {

struct LogPlan {
  UndoTable undo;
  Palette palette;
  bool stepped = false;  // has `step` events and is stepped by them alone
  std::int64_t events = 0;
  std::int64_t touches = 0;
  std::int64_t strokes = 0;  // begun, played or not
  std::int64_t steps = 0;    // to the end of the step of the last event
  std::int64_t last_time_us = 0;
  std::vector<std::int64_t> stops;  // steps done at each of the points asked for
  std::string sha256;
  std::string salvaged;  // what salvage dropped; empty if nothing
};

/// Reads the log from its first event to its end and rewinds it. `maker` makes its paints; `budget`
/// counts its stamps, unless it is null. Errors: the reader's; those of the files; kUsage for a
/// stop that is not in the log; kLimit; kInterrupted.
Result<LogPlan> plan_log(log::Reader& reader, LogFiles& files,
                         const std::vector<StopPoint>& stops_wanted, const PaintMaker& maker = {},
                         const Control& control = {}, StampBudget* budget = nullptr);

}  // namespace pentimento
