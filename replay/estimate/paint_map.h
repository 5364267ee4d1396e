#pragma once
// What paint the canvas would have, cell by cell of the guide. For estimates; nothing is simulated.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/field.h"
#include "core/brush/tip.h"
#include "core/brush/tip_pose.h"
#include "core/detail/store/detail_layout.h"
#include "replay/estimate/awake_tiles.h"
#include "replay/estimate/carried_paint.h"
#include "replay/estimate/detail_cost.h"
#include "replay/estimate/drips.h"
#include "replay/estimate/paint_survey.h"
#include "replay/session/log_session.h"

namespace pentimento {

class PaintMap {
 public:
  /// Begins with what the session's dump has wet and dry.
  PaintMap(const LogSession& session, const DetailCost& cost);

  /// Where paint is laid.
  struct Deposition {
    const TipPose& pose;
    const Tip& tip;
    const CarriedPaint& paint;
    std::uint32_t stroke;
    std::int64_t step;
    const BrushSettings& brush;
  };
  /// The tip's cells hold what it lays from now on; returns what lay there.
  CarriedPaint::Contact deposit(const Deposition& laying);
  void dry(std::int64_t step);
  void clear(std::int64_t step);
  /// Gravity along the canvas, in the grid's frame.
  void tilt(double x_m_s2, double y_m_s2, std::int64_t step);
  PaintSurvey finish(std::int64_t end_step);
  /// The channels that are wet in a cell of the guide.
  std::uint32_t wet_channels(int x, int y) const { return wet_(x, y).mask; }

 private:
  /// What is wet in a cell of the guide.
  struct WetCell {
    std::uint32_t mask = 0;    // channels
    std::uint32_t main = 0;    // of them those that a brush was loaded with
    std::uint32_t stroke = 0;  // the last one here
    int layers = 0;            // a stroke on another's opens the next (R26)
    std::uint32_t thin = 0;    // 1: it runs
  };
  void begin(const CanvasState& state);
  /// Cells of `box` may hold paint from now on.
  void reach(const CellBox& box);
  void deposit(WetCell& cell, std::uint32_t mask, std::uint32_t stroke);
  void account(std::int64_t step);
  void run_down();
  void measure();
  /// Of the sleep tiles: those that paint comes to, or near, and those of them that are used at
  /// once.
  std::pair<double, double> sleep_tile_shares() const;
  std::int64_t tile_bytes(const CellBox& box) const;
  std::int64_t written_bytes(std::span<const std::uint32_t> rows, std::uint32_t mask) const;

  CanvasGeometry grid_;
  DetailLayout layout_;
  DetailCost cost_;
  int layers_, channels_, bands_;
  // Planes of a large grid take memory only where they are written to, and only `reached_` is
  // looked at: a small painting on a large canvas costs what it covers.
  Field<WetCell> wet_;
  Field<std::uint8_t> dried_;  // something dried here
  CellBox reached_;            // no cell beyond it was ever written to
  AwakeTiles awake_;
  TiltedTime tilted_;
  double step_s_;
  float sleep_tile_m_;
  bool full_;  // a dump fills the canvas
  PaintSurvey survey_;
};

}  // namespace pentimento
