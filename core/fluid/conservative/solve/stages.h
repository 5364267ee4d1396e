#pragma once
// Runs several stencil passes over a plane while a part of the plane stays in the cache. The result
// is the same as that of pass after pass over the whole plane.

#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/runs.h"

namespace pentimento::conservative {

/// Rows [y0, y1).
struct RowSpan {
  int y0 = 0, y1 = 0;
};

/// The runs of a grid, row after row, with an index by row.
class RunIndex {
 public:
  RunIndex() = default;
  RunIndex(std::vector<Run> runs, int height);
  const std::vector<Run>& runs() const { return runs_; }
  /// The rows that have runs, as spans with empty rows between them.
  const std::vector<RowSpan>& spans() const { return spans_; }
  /// How many cells the runs of these rows have.
  std::int64_t cells(RowSpan rows) const { return cells_above(rows.y1) - cells_above(rows.y0); }
  std::int64_t cells() const { return cells_above_.empty() ? 0 : cells_above_.back(); }
  /// Calls body(run) for each run of row y of the grid.
  template <typename Body>
  void for_row(int y, const Body& body) const {
    const auto row = static_cast<std::size_t>(y);
    for (std::size_t k = begin_[row]; k < begin_[row + 1]; ++k) body(runs_[k]);
  }

 private:
  std::int64_t cells_above(int y) const { return cells_above_[static_cast<std::size_t>(y)]; }
  std::vector<Run> runs_;
  std::vector<std::size_t> begin_;         // of each row, and the end
  std::vector<std::int64_t> cells_above_;  // each row, and the end
  std::vector<RowSpan> spans_;
};

/// Calls pass(stage, run) for every run and the stages 0 .. stages-1, each run and stage once.
/// When stage s > 0 of a row is called, stage s-1 is done on that row and on both neighbour rows.
/// When any stage s is called, stage s+1 is done on none of them. So two planes, written in turn,
/// hold all that is needed. Stage 0 may read neighbour rows of no plane that it writes; of planes
/// that later stages overwrite it finds them as they were.
/// Scheme: bands of rows, a few for each thread, with as many cells each. In each band the stages
///   follow one another down the rows, each one row behind the stage before, so that they share few
///   rows. A band shrinks by a row with each stage. The gap between two bands, which grows in the
///   same way, is filled by whoever is done with the second of them (Wonnacott, Int. J. Parallel
///   Program. 30 (2002) 181-221). Rows without a run part what is above from what is below.
/// The result does not depend on how many cells a band has.
void for_stages(const Threads& threads, const RunIndex& index, int stages,
                const std::function<void(int stage, const Run& run)>& pass);
/// The same in bands of `cells` cells, or more if so few do not suffice.
void for_stages_in(std::int64_t cells, const Threads& threads, const RunIndex& index, int stages,
                   const std::function<void(int stage, const Run& run)>& pass);

}  // namespace pentimento::conservative
