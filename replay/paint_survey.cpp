#include "replay/paint_survey.h"

#include <cmath>
#include <optional>

#include "core/brush/brush_settings.h"
#include "formats/log/slider_fields.h"
#include "replay/paint_map.h"
#include "replay/timeline/timeline.h"

namespace pentimento {

namespace {

constexpr float kSmallestCells = 1.5f;  // as in the transfer

/// The brush in the hand, as far as it matters to where paint goes.
class SurveyHand {
 public:
  SurveyHand(const LogSession& session, PaintMap& map) : session_(session), map_(map) {
    take(session.brushes.first());
    load(session.first_color);
  }
  void apply(const Cue& cue) {
    if (const auto* stamp = std::get_if<StrokeStamp>(&cue.what)) {
      const float smallest_m = kSmallestCells * session_.grid.dx_m();
      carried_ |= map_.lay({pose_of(stamp->stamp, *brush_, smallest_m), *tip_, carried_, cue.step,
                            settling_steps(settings_)});
    } else if (const auto* action = std::get_if<log::Action>(&cue.what)) {
      act(*action, cue.step);
    }
  }

 private:
  void act(const log::Action& action, std::int64_t step) {
    if (const auto* color = std::get_if<log::Color>(&action)) {
      load(session_.palette.find(*color));
    } else if (const auto* brush = std::get_if<log::BrushChange>(&action)) {
      take(session_.brushes.find(brush->name));
    } else if (const auto* slider = std::get_if<log::Slider>(&action)) {
      Model unused;
      log::apply_slider(slider->name, slider->value, settings_, unused);
    } else if (std::holds_alternative<log::Dry>(action)) {
      map_.dry();
    } else if (std::holds_alternative<log::Clear>(action)) {
      map_.clear();
    } else if (const auto* g = std::get_if<log::Gravity>(&action)) {
      map_.tilt(std::hypot(g->x_m_s2, g->y_m_s2), step);
    }
  }
  void take(const BrushDefinition& brush) {
    brush_ = &brush;
    tip_.emplace(brush);
  }
  void load(int pigment) {
    // Optical channels are all there with any paint.
    const auto& loads = session_.basis.load;
    carried_ = 0;
    for (int c = 0; c < session_.basis.channels() && c < 32; ++c)
      if (loads(c, pigment) > 0) carried_ |= 1u << c;
  }

  const LogSession& session_;
  PaintMap& map_;
  const BrushDefinition* brush_ = nullptr;
  std::optional<Tip> tip_;
  BrushSettings settings_;
  std::uint32_t carried_ = 0;
};

}  // namespace

Result<PaintSurvey> survey_paint(LogSession& session, const DetailCost& cost,
                                 const Control& control) {
  PaintMap map(session, cost);
  SurveyHand hand(session, map);
  Timeline timeline(*session.reader, {session.plan.undo, session.brushes, session.plan.stepped, 1});
  for (;;) {
    Result<std::optional<Cue>> cue = timeline.next();
    if (!cue) return cue.error();
    if (!cue->has_value() || (*cue)->step >= session.steps) break;
    if (Result<void> go = control.go_on(); !go) return go.error();
    control.report({"survey", (*cue)->step, session.steps});
    hand.apply(**cue);
  }
  if (Result<void> back = session.reader->rewind(); !back) return back.error();
  return map.finish(session.steps);
}

}  // namespace pentimento
