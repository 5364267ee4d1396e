#pragma once
// Where paint will be and where it will move, from the log alone: the hand that paints the picture
// plays it to a painter who only notes (survey_painter.h). What estimates of memory and time are
// made of.

#include <cstdint>

#include "core/base/result.h"
#include "replay/estimate/awake_tiles.h"
#include "replay/estimate/detail_cost.h"
#include "replay/session/log_session.h"

namespace pentimento {

struct PaintSurvey {
  std::int64_t stamps = 0;
  double stamped_cells = 0;      // cells of the guide under stamps, each time counted
  double stamped_channels = 0;   // each of them once for every channel wet there
  MovingPaint awake;             // after stamps
  double tilted_cell_steps = 0;  // cells of wet tiles, per step in which the canvas is tilted
  std::int64_t tiles = 0;        // of the detail canvas that ever have paint
  std::int64_t all_tiles = 0;
  double detail_bytes = 0;  // of the detail canvas, when it holds most
  // Of the guide's sleep tiles, those that paint comes to, or near. 1: not known, or paint may run
  // anywhere, or a dump has filled all planes.
  double reached_share = 1;
  double used_share = 1;  // of the same, those that hold work of the scheme at once
};

/// Plays the session's log from its first event up to its last stop and rewinds it. Errors: the
/// reader's; the hand's; kInterrupted.
Result<PaintSurvey> survey_paint(LogSession& session, const DetailCost& cost,
                                 const Control& control = {});

}  // namespace pentimento
