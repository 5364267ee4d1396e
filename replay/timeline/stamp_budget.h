#pragma once
// How many stamps a log asks for, counted while it is read for the first time: a brush of a
// hundredth of a millimetre with the narrowest spacing makes ten million of one stroke. Such a log
// is refused before its first step. The count follows the straight way between samples, the part
// that is near the canvas; strokes that are undone later count as well.

#include <cstdint>
#include <map>

#include "core/base/result.h"
#include "formats/log/tables/events.h"
#include "formats/log/tables/limits.h"
#include "replay/log/brushes.h"
#include "replay/timeline/brush_track.h"

namespace pentimento {

class StampBudget {
 public:
  /// `brushes` must outlive the budget.
  StampBudget(const log::Header& header, const BrushTable& brushes, const log::Limits& limits);

  /// Takes the next event. Errors, without file and line: kLimit.
  Result<void> add(const log::Event& event);
  /// So far.
  double stamps() const { return stamps_; }

 private:
  struct Place {
    double x_m = 0, y_m = 0, diameter_m = 0;
  };
  double stamps_between(const Place& a, const Place& b) const;

  const double width_m_, height_m_;
  const log::Limits limits_;
  BrushTrack brush_;
  std::map<std::int64_t, Place> down_;  // by the touch's id
  double stamps_ = 0;
};

}  // namespace pentimento
