#pragma once
// The two things about the brush that shape a path rather than a stamp: its size and the spacing of
// stamps, followed through the log's `slider` and `brush` events in reading order.

#include <string>

#include "core/brush/brush_settings.h"
#include "formats/log/tables/events.h"
#include "replay/log/brushes.h"

namespace pentimento {

class BrushTrack {
 public:
  /// `brushes` outlives the track.
  explicit BrushTrack(const BrushTable& brushes);

  void follow(const log::Action& action);

  float diameter_m() const { return settings_.size_m; }
  /// Of the diameter: the brush's own spacing, or the slider's if it has none.
  double spacing_frac() const;

 private:
  const BrushTable& brushes_;
  BrushSettings settings_;
  const BrushDefinition* brush_;
};

}  // namespace pentimento
