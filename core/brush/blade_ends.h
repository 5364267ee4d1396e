#pragma once
// The ends of a blade as the cells of one grid see them. The blade lets paint pass under its ends,
// which are little wider than a cell. What it does there is not linear, so it is averaged over a
// cell and not read at the cell's centre: else a ridge that runs slanting would come and go from
// cell to cell, and a finer canvas would make beads of it.

#include "core/brush/tip.h"
#include "core/brush/tip_pose.h"
#include "core/canvas/canvas_state.h"

namespace pentimento {

/// Tables over v in tip coordinates, of values in [0,1].
struct BladeEnds {
  BristleTable open;   // share of the cell that lies under the ends
  BristleTable takes;  // how hard the cell is scraped: 1 in the middle of the blade, 0 at its ends
};

/// The ends of `tip`, posed on `grid`.
///   open = <e>,  takes = ln <(1 - s)^(1 - e)> / ln(1 - s)
/// e: Tip::end_table(); s: kScraped; <>: mean over cell_width(). A cell of which half lies under an
/// end keeps half of its paint once the blade is past. Scheme: the tables are linear between 129
/// steps, their means exact. Stable: values stay in [0,1]. Source: ours. Departs from it: where in
/// the cell the paint lies is not known.
BladeEnds blade_ends(const Tip& tip, const TipPose& pose, const CanvasGeometry& grid);

}  // namespace pentimento
