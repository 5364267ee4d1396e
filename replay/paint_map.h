#pragma once
// What paint the canvas would have, cell by cell of the guide. For estimates; nothing is simulated.

#include <cstdint>
#include <vector>

#include "core/brush/footprint.h"
#include "core/brush/tip.h"
#include "core/detail/detail_layout.h"
#include "replay/awake_tiles.h"
#include "replay/detail_cost.h"
#include "replay/log_session.h"
#include "replay/paint_survey.h"

namespace pentimento {

class PaintMap {
 public:
  /// Begins with what the session's dump has wet and dry.
  PaintMap(const LogSession& session, const DetailCost& cost);

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
  void clear();
  void tilt(double lateral_m_s2, std::int64_t step) { awake_.tilt(lateral_m_s2, step); }
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
  void measure();

  CanvasGeometry grid_;
  DetailLayout layout_;
  DetailCost cost_;
  int layers_, channels_, bands_;
  std::vector<std::uint32_t> wet_;   // channels that the cell has wet
  std::vector<std::uint8_t> dried_;  // something dried here
  AwakeTiles awake_;
  PaintSurvey survey_;
};

}  // namespace pentimento
