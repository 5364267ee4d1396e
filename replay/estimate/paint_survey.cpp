#include "replay/estimate/paint_survey.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "core/brush/brush_settings.h"
#include "formats/log/tables/slider_fields.h"
#include "replay/estimate/carried_paint.h"
#include "replay/estimate/paint_map.h"
#include "replay/timeline/timeline.h"

namespace pentimento {

namespace {

constexpr float kSmallestCells = 1.5f;    // as in the transfer
constexpr double kRefillDiameters = 0.1;  // R22

/// The brush in the hand, as far as it matters to where paint goes.
class SurveyHand {
 public:
  SurveyHand(const LogSession& session, PaintMap& map) : session_(session), map_(map) {
    take(session.brushes.first());
    dip(session.first_color, {0, 1});
  }
  void apply(const Cue& cue) {
    if (const auto* stamp = std::get_if<StrokeStamp>(&cue.what)) {
      deposit(stamp->stamp, stroke_[stamp->slot], cue.step);
    } else if (const auto* begun = std::get_if<StrokeBegin>(&cue.what)) {
      stroke_[begun->slot] = begun->stroke_id;
    } else if (const auto* action = std::get_if<log::Action>(&cue.what)) {
      act(*action, cue.step);
    }
  }

 private:
  void deposit(const Stamp& stamp, std::uint32_t stroke, std::int64_t step) {
    const TipPose pose = pose_of(stamp, *brush_, kSmallestCells * session_.grid.dx_m());
    const double diameters = static_cast<double>(stamp.travel_m) / pose.diameter_m;
    const auto share = [](double frac, double lengths) { return 1 - std::pow(1 - frac, lengths); };
    const double pickup = std::max(settings_.pickup, brush_->absorb);
    const double refill = brush_->film > 0 ? settings_.refill : 0;
    const auto met = map_.deposit({pose, *tip_, paint_, stroke, step, settings_});
    paint_.pass(met, share(pickup, diameters), share(refill, diameters / kRefillDiameters));
  }
  void act(const log::Action& action, std::int64_t step) {
    if (const auto* color = std::get_if<log::Color>(&action)) {
      dip(session_.palette.find(*color), color->across.value_or(std::array<double, 2>{0, 1}));
    } else if (const auto* brush = std::get_if<log::BrushChange>(&action)) {
      take(session_.brushes.find(brush->name));
    } else if (const auto* slider = std::get_if<log::Slider>(&action)) {
      Model unused;
      log::apply_slider(slider->name, slider->value, settings_, unused);
    } else if (std::holds_alternative<log::Dry>(action)) {
      map_.dry(step);
    } else if (std::holds_alternative<log::Clear>(action)) {
      map_.clear(step);
    } else if (const auto* g = std::get_if<log::Gravity>(&action)) {
      // At rest the sensor reads what holds it up.
      map_.tilt(-g->x_m_s2, g->y_m_s2, step);
    }
  }
  void take(const BrushDefinition& brush) {
    brush_ = &brush;
    tip_.emplace(brush);
    paint_.take(brush.film > 0);
  }
  void dip(int pigment, const std::array<double, 2>& across) {
    // Optical channels are all there with any paint.
    const auto& loads = session_.basis.load;
    std::uint32_t mask = 0;
    for (int c = 0; c < session_.basis.channels() && c < CarriedPaint::kChannels; ++c)
      if (loads(c, pigment) > 0) mask |= 1u << c;
    paint_.dip(mask, across[0], across[1]);
  }

  const LogSession& session_;
  PaintMap& map_;
  const BrushDefinition* brush_ = nullptr;
  std::optional<Tip> tip_;
  BrushSettings settings_;
  CarriedPaint paint_;
  std::map<int, std::uint32_t> stroke_;  // of each hand
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
