#pragma once
// Runs several stencil passes over a plane while a part of the plane stays in the cache. The result
// is the same as that of pass after pass over the whole plane.

#include <functional>
#include <vector>

#include "core/base/runs.h"

namespace pentimento::conservative {

/// The runs of a grid with an index by row.
class RunIndex {
 public:
  RunIndex() = default;
  RunIndex(std::vector<Run> runs, int height);
  const std::vector<Run>& runs() const { return runs_; }
  int height() const { return static_cast<int>(begin_.size()) - 1; }
  bool any(int y0, int y1) const { return first(y0) != first(y1); }
  /// Calls body(run) for each run of the rows [y0, y1), which are cut to the grid.
  template <typename Body>
  void for_rows(int y0, int y1, const Body& body) const {
    for (std::size_t k = first(y0); k < first(y1); ++k) body(runs_[k]);
  }

 private:
  std::size_t first(int y) const {
    return begin_[static_cast<std::size_t>(std::clamp(y, 0, height()))];
  }
  std::vector<Run> runs_;
  std::vector<std::size_t> begin_;  // of each row, and the end
};

/// Calls pass(stage, run) for every run and the stages 0 .. stages-1, each run and stage once.
/// When stage s > 0 of a row is called, stage s-1 is done on that row and on both neighbour rows,
/// and stage s+1 is done on none of them. So two planes, written in turn, hold all that is needed.
/// Stage 0 may depend on no other row.
/// Scheme: bands of rows, a few for each thread. In each band the stages follow one another down
///   the rows, each one row behind the stage before, so that they share few rows. A band shrinks by
///   a row with each stage. Then the gaps between the bands are filled, which grow in the same way
///   (Wonnacott, Int. J. Parallel Program. 30 (2002) 181-221).
/// The result does not depend on how many rows a band has.
void for_stages(const Threads& threads, const RunIndex& index, int stages,
                const std::function<void(int stage, const Run& run)>& pass);
/// The same in bands of `rows` rows, or more if so few do not suffice.
void for_stages_in(int rows, const Threads& threads, const RunIndex& index, int stages,
                   const std::function<void(int stage, const Run& run)>& pass);

}  // namespace pentimento::conservative
