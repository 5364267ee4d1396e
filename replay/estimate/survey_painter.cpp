#include "replay/estimate/survey_painter.h"

#include "core/base/check.h"
#include "core/brush/stamp_shares.h"

namespace pentimento {

SurveyPainter::SurveyPainter(const LogSession& session, const DetailCost& cost)
    : basis_(session.basis),
      grid_(session.grid),
      model_(session.model),
      held_(basis_, model_, session.tips),
      map_(session, cost) {}

void SurveyPainter::set_settings(const BrushSettings& settings) {
  if (held_.set_settings(settings)) dip_all();
}

void SurveyPainter::set_brush(const BrushDefinition& brush) {
  if (held_.take(brush)) dip_all();
}

void SurveyPainter::set_color(int pigment) {
  held_.set_color(pigment);
  dip_all();
}

void SurveyPainter::set_color(int pigment, float from, float to) {
  const ReservoirRows rows = held_.set_color(pigment, from, to);
  if (!held_.brush().lays_paint()) return;
  for (auto& [id, touch] : touches_) touch.paint.dip(channels_of(pigment), rows);
}

void SurveyPainter::begin_stroke(int touch_id, std::uint32_t stroke_id) {
  const auto [found, is_new] = touches_.try_emplace(touch_id);
  SurveyTouch& touch = found->second;
  if (is_new) dip(touch);
  touch.down = true;
  touch.stroke_id = stroke_id;
}

void SurveyPainter::stamp(int touch_id, const Stamp& stamp) {
  const auto found = touches_.find(touch_id);
  PENTIMENTO_CHECK(found != touches_.end() && found->second.down);
  SurveyTouch& touch = found->second;
  const BrushDefinition& brush = held_.brush();
  const BrushSettings& settings = held_.settings();
  const TipPose pose = pose_on(grid_, stamp, brush);
  const CarriedPaint::Contact met =
      map_.deposit({pose, held_.tip(), touch.paint, touch.stroke_id, step_, settings});
  touch.paint.pass(met, static_cast<double>(pickup_share(stamp, brush, settings, pose)),
                   static_cast<double>(refill_share(stamp, brush, settings, pose)));
}

void SurveyPainter::end_stroke(int touch_id) {
  const auto touch = touches_.find(touch_id);
  if (touch != touches_.end()) touch->second.down = false;
}

/// At rest the sensor reads what holds it up: paint is pulled the other way.
void SurveyPainter::set_gravity(Vec3f gravity_m_s2) {
  map_.tilt(-static_cast<double>(gravity_m_s2.x), -static_cast<double>(gravity_m_s2.y), step_);
}

void SurveyPainter::set_model(const Model& model) {
  model_ = model;
  if (held_.reload()) dip_all();
}

/// The picture itself is the ground: it is neither wet nor dried paint.
void SurveyPainter::load(const std::vector<Field<float>>&) {
  map_.clear(step_);
}

/// As many as carried paint tells apart. Optical channels are all there with any paint.
std::uint32_t SurveyPainter::channels_of(int pigment) const {
  std::uint32_t mask = 0;
  for (int c = 0; c < basis_.channels() && c < CarriedPaint::kChannels; ++c)
    if (basis_.load(c, pigment) > 0) mask |= 1u << c;
  return mask;
}

/// A clean brush gets its colours; what lays no paint starts with none.
void SurveyPainter::dip(SurveyTouch& touch) const {
  touch.paint = {};
  if (!held_.brush().lays_paint()) return;
  for (const DippedColor& color : held_.colors())
    touch.paint.dip(channels_of(color.pigment), color.rows);
}

void SurveyPainter::dip_all() {
  for (auto& [id, touch] : touches_) dip(touch);
}

}  // namespace pentimento
