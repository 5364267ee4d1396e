#pragma once
// The painter of estimates: it takes what the hand does as the simulation takes it, and notes on a
// map which paint comes to lie where. Nothing is simulated.

#include <cstdint>
#include <map>

#include "core/brush/held_brush.h"
#include "core/simulation/painter.h"
#include "replay/estimate/carried_paint.h"
#include "replay/estimate/paint_map.h"

namespace pentimento {

class SurveyPainter : public Painter {
 public:
  /// The session outlives it.
  SurveyPainter(const LogSession& session, const DetailCost& cost);

  /// What the hand does next, it does before step `step` of the session.
  void pass_to(std::int64_t step) { step_ = step; }
  /// What there was of everything until step `end_step`.
  PaintSurvey finish(std::int64_t end_step) { return map_.finish(end_step); }
  const PaintMap& map() const { return map_; }

  void set_settings(const BrushSettings& settings) override;
  void set_brush(const BrushDefinition& brush) override;
  void set_color(int pigment) override;
  void set_color(int pigment, float from, float to) override;
  void begin_stroke(int touch_id, std::uint32_t stroke_id) override;
  void stamp(int touch_id, const Stamp& stamp) override;
  void end_stroke(int touch_id) override;
  void set_gravity(Vec3f gravity_m_s2) override;
  void set_model(const Model& model) override;
  void dry() override { map_.dry(step_); }
  void clear() override { map_.clear(step_); }
  void load(const std::vector<Field<float>>& reflectance) override;
  const Model& model() const override { return model_; }
  const CanvasGeometry& geometry() const override { return grid_; }

 private:
  struct SurveyTouch {
    CarriedPaint paint;
    std::uint32_t stroke_id = 0;
    bool down = false;
  };
  std::uint32_t channels_of(int pigment) const;
  void dip(SurveyTouch& touch) const;
  void dip_all();

  const ChannelBasis& basis_;
  CanvasGeometry grid_;
  Model model_;
  HeldBrush held_;
  std::map<int, SurveyTouch> touches_;
  PaintMap map_;
  std::int64_t step_ = 0;
};

}  // namespace pentimento
