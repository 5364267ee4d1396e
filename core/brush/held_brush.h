#pragma once
// The brush in the hand: which it is, how its sliders stand and what it is dipped into. It says
// what a change of these does to the paint that brushes hold; that paint is its owner's.

#include <memory>
#include <vector>

#include "core/brush/brush_settings.h"
#include "core/brush/paint_load.h"
#include "core/brush/tip_rack.h"
#include "core/model/model.h"
#include "core/optics/channels.h"

namespace pentimento {

/// A colour on a part of the tip; the later lies over the earlier.
struct DippedColor {
  int pigment = 0;
  ReservoirRows rows;
};

class HeldBrush {
 public:
  /// The round brush with the first pigment of the palette that `basis` was made from. Both outlive
  /// it; the model may change, and reload() follows it.
  HeldBrush(const ChannelBasis& basis, const Model& model);

  /// True if it is another brush than the one in the hand: a clean one, to be dipped.
  [[nodiscard]] bool take(const BrushDefinition& brush);
  /// True if the sliders change what it is to hold: it is to be dipped anew.
  [[nodiscard]] bool set_settings(const BrushSettings& settings);
  /// After a change of the model: true likewise.
  [[nodiscard]] bool reload();
  /// The whole tip is to be dipped into it.
  void set_color(int pigment);
  /// The part [from, to] of its width is. Returns the rows to be dipped.
  ReservoirRows set_color(int pigment, float from, float to);

  const BrushDefinition& brush() const { return brush_; }
  const Tip& tip() const { return *tip_; }
  const BrushSettings& settings() const { return settings_; }
  const std::vector<DippedColor>& colors() const { return colors_; }
  /// What a brush that lays paint is dipped into.
  const PaintLoad& load() const { return load_; }

 private:
  PaintLoad wanted_load() const;
  PaintLoad load_of(int pigment) const;
  void check_pigment(int pigment) const;

  const ChannelBasis& basis_;
  const Model& model_;
  std::vector<float> amount_;  // per channel, as in PaintLoad
  BrushDefinition brush_;
  TipRack tips_;
  std::shared_ptr<const Tip> tip_;
  BrushSettings settings_;
  std::vector<DippedColor> colors_ = {{0, kAllRows}};
  PaintLoad load_;
};

}  // namespace pentimento
