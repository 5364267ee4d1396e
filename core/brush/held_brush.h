#pragma once
// The brush in the hand: which brush it is, its sliders, and the paint that it is dipped into. The
// functions say what a change does to the paint that brushes hold; the caller keeps that paint.

#include <memory>
#include <vector>

#include "core/brush/brush_settings.h"
#include "core/brush/paint_load.h"
#include "core/brush/tip_rack.h"
#include "core/model/model.h"
#include "core/optics/channels.h"

namespace pentimento {

/// A colour on a part of the tip. A later one lies over an earlier one.
struct DippedColor {
  int pigment = 0;
  ReservoirRows rows;
};

class HeldBrush {
 public:
  /// Begins as the round brush with the first pigment of the palette that `basis` was made from.
  /// `basis` and `model` must outlive the object. The model may change; then call reload(). Tips
  /// are drawn into `tips`, which others may share; nullptr: into a rack of its own.
  HeldBrush(const ChannelBasis& basis, const Model& model, std::shared_ptr<TipRack> tips = nullptr);

  /// Becomes what `other` is, but of its own basis and model, which must be equal to those of
  /// `other`. From then on both share the tips that either of them draws.
  void become(const HeldBrush& other);

  /// Takes a brush. True if it is another brush than the one in the hand: it is clean, and the
  /// caller dips it.
  [[nodiscard]] bool take(const BrushDefinition& brush);
  /// Sets the sliders. True if that changes the load: the caller dips the brush anew.
  [[nodiscard]] bool set_settings(const BrushSettings& settings);
  /// Call it after a change of the model. True if that changes the load.
  [[nodiscard]] bool reload();
  /// Chooses the pigment for the whole tip.
  void set_color(int pigment);
  /// Chooses the pigment for the part [from, to] of the tip's width, 0..1. Returns the rows of the
  /// reservoir to dip.
  ReservoirRows set_color(int pigment, float from, float to);

  const BrushDefinition& brush() const { return brush_; }
  /// Draws the tip, the first time that the brush is used.
  const Tip& tip();
  const BrushSettings& settings() const { return settings_; }
  const std::vector<DippedColor>& colors() const { return colors_; }
  /// The load, for a brush that deposits paint.
  const PaintLoad& load() const { return load_; }

 private:
  PaintLoad wanted_load() const;
  PaintLoad load_of(int pigment) const;
  void check_pigment(int pigment) const;

  const ChannelBasis& basis_;
  const Model& model_;
  std::vector<float> amount_;  // per channel, as in PaintLoad
  BrushDefinition brush_;
  std::shared_ptr<TipRack> tips_;
  std::shared_ptr<const Tip> tip_;  // nullptr: not asked for yet
  BrushSettings settings_;
  std::vector<DippedColor> colors_ = {{0, kAllRows}};
  PaintLoad load_;
};

}  // namespace pentimento
