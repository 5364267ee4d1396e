#include "replay/estimate/paint_survey.h"

#include <algorithm>
#include <optional>

#include "replay/estimate/survey_painter.h"
#include "replay/play/hand.h"
#include "replay/timeline/timeline.h"

namespace pentimento {

namespace {
/// The step at which the hand stops; none: where the log ends.
std::optional<std::int64_t> last_stop(const LogSession& session) {
  const std::vector<std::int64_t>& stops = session.plan.stops;
  if (stops.empty()) return std::nullopt;
  return *std::max_element(stops.begin(), stops.end());
}
}  // namespace

Result<PaintSurvey> survey_paint(LogSession& session, const DetailCost& cost,
                                 const Control& control) {
  SurveyPainter painter(session, cost);
  Hand hand(painter, hand_input(session));
  const std::optional<std::int64_t> stop = last_stop(session);
  Timeline timeline(*session.reader, {session.plan.undo, session.brushes, session.plan.stepped, 1});
  for (;;) {
    Result<std::optional<Cue>> cue = timeline.next(control.cancelled);
    if (!cue) return cue.error();
    if (!cue->has_value() || (stop && (*cue)->step >= *stop)) break;
    if (Result<void> go = control.go_on(); !go) return go.error();
    control.report({"survey", (*cue)->step, session.steps});
    painter.pass_to((*cue)->step);
    if (Result<void> applied = hand.apply(**cue); !applied) return applied.error();
  }
  if (Result<void> back = session.reader->rewind(); !back) return back.error();
  return painter.finish(session.steps);
}

}  // namespace pentimento
