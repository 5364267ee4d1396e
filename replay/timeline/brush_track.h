#pragma once
// Follows size and spacing of the brush through the log's `slider` and `brush` events, in the order
// of reading. These two shape the path rather than a single stamp.

#include <string>

#include "core/brush/brush_settings.h"
#include "formats/log/tables/events.h"
#include "replay/log/brushes.h"

namespace pentimento {

class BrushTrack {
 public:
  /// `brushes` must outlive the track.
  explicit BrushTrack(const BrushTable& brushes);

  void follow(const log::Action& action);

  float diameter_m() const { return settings_.size_m; }
  /// Spacing in diameters: the brush's own, or the slider's if the brush has none.
  double spacing_frac() const;

 private:
  const BrushTable& brushes_;
  BrushSettings settings_;
  const BrushDefinition* brush_;
};

}  // namespace pentimento
