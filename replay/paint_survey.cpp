#include "replay/paint_survey.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <vector>

#include "core/brush/brush_settings.h"
#include "core/brush/footprint.h"
#include "core/brush/tip.h"
#include "core/detail/detail_layout.h"
#include "formats/log/slider_fields.h"
#include "replay/timeline/timeline.h"

namespace pentimento {

namespace {

// After a touch paint moves this long; then it stands (mean over the samples). Thin paint, the more
// of it the longer.
constexpr std::int64_t kSettlingSteps = 9, kRunningSteps = 45;
constexpr float kThinPigment = 0.3f;

std::int64_t settling_steps(const BrushSettings& brush) {
  if (brush.pigment_frac >= kThinPigment) return kSettlingSteps;
  return kSettlingSteps + static_cast<std::int64_t>(kRunningSteps * brush.medium_frac);
}
constexpr double kWakingTilt_m_s2 = 0.3;  // more than this along the canvas, and all paint moves
constexpr int kAwakeTile = 32;            // cells a side: the scheme's sleeping tiles, about
constexpr float kSmallestCells = 1.5f;    // as in the transfer

/// What the paint of the canvas would be, cell by cell of the guide.
class PaintMap {
 public:
  PaintMap(const LogSession& session, const DetailCost& cost)
      : grid_(session.grid),
        layout_(session.grid, session.detail),
        cost_(cost),
        layers_(session.model.layers),
        channels_(session.basis.channels()),
        wet_(cells(), 0),
        dried_(cells(), 0),
        columns_((grid_.width + kAwakeTile - 1) / kAwakeTile),
        touched_(
            static_cast<std::size_t>(columns_ * ((grid_.height + kAwakeTile - 1) / kAwakeTile)),
            -1),
        settling_(touched_.size(), kSettlingSteps) {
    if (session.start) begin(session.start->state);
  }

  /// Where paint is laid.
  struct Laying {
    const TipPose& pose;
    const Tip& tip;
    std::uint32_t mask;  // the channels that it has
    std::int64_t step, settling_steps;
  };
  /// The tip's cells hold the channels in `mask` from now on; returns what lay there.
  std::uint32_t lay(const Laying& laying);
  void dry();
  void clear() {
    std::fill(wet_.begin(), wet_.end(), 0u);
    std::fill(dried_.begin(), dried_.end(), std::uint8_t{0});
    std::fill(touched_.begin(), touched_.end(), -1);
    wet_tiles_ = 0;
  }
  /// Gravity along the canvas, from this step on.
  void tilt(double lateral_m_s2, std::int64_t step);
  PaintSurvey finish(std::int64_t end_step);

 private:
  void begin(const CanvasState& state);
  std::size_t cells() const {
    return static_cast<std::size_t>(grid_.width) * static_cast<std::size_t>(grid_.height);
  }
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(grid_.width) +
           static_cast<std::size_t>(x);
  }
  void wake(int x, int y, std::int64_t step, std::int64_t settling_steps);
  void measure();

  CanvasGeometry grid_;
  DetailLayout layout_;
  DetailCost cost_;
  int layers_, channels_;
  std::vector<std::uint32_t> wet_;   // channels that the cell has wet
  std::vector<std::uint8_t> dried_;  // something dried here
  int columns_;
  std::vector<std::int64_t> touched_;   // per awake tile: the step of the last stamp; -1 = none
  std::vector<std::int64_t> settling_;  // per awake tile: steps that its paint moves after that
  std::int64_t wet_tiles_ = 0;          // of them, touched since the last clear or drying
  std::int64_t tilted_since_ = -1;      // step; -1 = lies flat
  PaintSurvey survey_;
};

/// What a dump has wet and dry.
void PaintMap::begin(const CanvasState& state) {
  for (int y = 0; y < grid_.height; ++y)
    for (int x = 0; x < grid_.width; ++x) {
      std::uint32_t& wet = wet_[at(x, y)];
      for (std::size_t p = 0; p < state.pigment.size(); ++p) {
        const auto c = p % static_cast<std::size_t>(state.channels);
        if (c < 32 && state.pigment[p](x, y) > 0) wet |= 1u << c;
      }
      if (wet != 0) wake(x, y, 0, kSettlingSteps);
      dried_[at(x, y)] = state.base_m(x, y) != state.paper_m(x, y) ? 1 : 0;
    }
}

/// While the canvas is tilted everything wet is awake.
void PaintMap::tilt(double lateral_m_s2, std::int64_t step) {
  if (tilted_since_ >= 0)
    survey_.tilted_cell_steps +=
        static_cast<double>((step - tilted_since_) * wet_tiles_) * kAwakeTile * kAwakeTile;
  tilted_since_ = lateral_m_s2 > kWakingTilt_m_s2 ? step : -1;
}

void PaintMap::wake(int x, int y, std::int64_t step, std::int64_t settling_steps) {
  const auto tile = static_cast<std::size_t>(y / kAwakeTile * columns_ + x / kAwakeTile);
  std::int64_t& last = touched_[tile];
  if (last < 0) ++wet_tiles_;
  if (last >= 0 && step > last && tilted_since_ < 0)
    survey_.awake_cell_steps +=
        static_cast<double>(std::min(settling_[tile], step - last)) * kAwakeTile * kAwakeTile;
  last = step;
  settling_[tile] = settling_steps;
}

std::uint32_t PaintMap::lay(const Laying& laying) {
  const TipPose& pose = laying.pose;
  const Tip& tip = laying.tip;
  const CellBox box = box_of(pose, tip.extent(), grid_);
  if (box.empty()) return 0;
  const TipLevel& level = tip.level_for(grid_.dx_m() / pose.diameter_m);
  std::uint32_t met = 0;
  for (int y = box.y; y < box.y + box.height; ++y) {
    const TipRow row = tip_row(pose, box, grid_, y);
    for (int x = 0; x < box.width; ++x) {
      if (!(level.at(row.u(x), row.v(x)) > 0)) continue;
      std::uint32_t& cell = wet_[at(box.x + x, y)];
      met |= cell;
      cell |= laying.mask;
      survey_.stamped_cells += 1;
    }
  }
  for (int y = box.y; y < box.y + box.height + kAwakeTile; y += kAwakeTile)
    for (int x = box.x; x < box.x + box.width + kAwakeTile; x += kAwakeTile)
      wake(std::min(x, box.x + box.width - 1), std::min(y, box.y + box.height - 1), laying.step,
           laying.settling_steps);
  ++survey_.stamps;
  return met;
}

void PaintMap::dry() {
  measure();
  std::fill(touched_.begin(), touched_.end(), -1);
  wet_tiles_ = 0;
  for (std::size_t i = 0; i < wet_.size(); ++i) {
    if (wet_[i] != 0) dried_[i] = 1;
    wet_[i] = 0;
  }
}

/// The finer canvas as it would be now.
void PaintMap::measure() {
  double bytes = 0;
  std::int64_t used = 0;
  for (int t = 0; t < layout_.tiles(); ++t) {
    const GuideBox box = layout_.box(t);
    std::uint32_t wet = 0;
    bool dried = false;
    for (int y = box.y0; y < box.y1; ++y)
      for (int x = box.x0; x < box.x1; ++x) {
        wet |= wet_[at(x, y)];
        dried = dried || dried_[at(x, y)] != 0;
      }
    bytes += cost_.bare_tile;
    if (wet == 0 && !dried) continue;
    ++used;
    const double fine = static_cast<double>(layout_.side()) * layout_.side();
    const int planes = layers_ * std::min(std::popcount(wet), channels_);
    bytes += fine * (wet != 0 ? cost_.wet_cell + planes * cost_.pigment_cell : cost_.base_cell);
    if (dried) bytes += fine * cost_.dried_cell;
  }
  survey_.detail_bytes = std::max(survey_.detail_bytes, bytes);
  survey_.tiles = std::max(survey_.tiles, used);
}

PaintSurvey PaintMap::finish(std::int64_t end_step) {
  measure();
  tilt(0, end_step);
  for (std::size_t i = 0; i < touched_.size(); ++i)
    if (touched_[i] >= 0)
      survey_.awake_cell_steps +=
          static_cast<double>(std::clamp<std::int64_t>(end_step - touched_[i], 0, settling_[i])) *
          kAwakeTile * kAwakeTile;
  survey_.all_tiles = layout_.tiles();
  return survey_;
}

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
