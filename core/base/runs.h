#pragma once
// Runs: which cells a pass visits. A run is cells of one row side by side, all awake.

#include <algorithm>
#include <vector>

#include "core/base/threads.h"

namespace pentimento::conservative {

/// Cells [x0, x1) of row y.
struct Run {
  int y = 0, x0 = 0, x1 = 0;
  int size() const { return x1 - x0; }
};

/// Calls body(run) for each run, on several threads. A body may write only what belongs to its run.
template <typename Body>
void for_runs(const Threads& threads, const std::vector<Run>& runs, const Body& body) {
  if (runs.empty()) return;
  // A few microseconds of work: to hand out a task takes one, and the last one keeps others
  // waiting.
  constexpr int kCellsPerTask = 4096;
  const int mean = std::max(1, (runs.front().size() + runs.back().size()) / 2);
  threads.for_ranges(0, static_cast<int>(runs.size()), std::max(1, kCellsPerTask / mean),
                     [&](int begin, int end) {
                       for (int i = begin; i < end; ++i) body(runs[static_cast<std::size_t>(i)]);
                     });
}

/// The runs that the given runs cover on a grid with half as many cells along each axis.
std::vector<Run> coarsen_runs(const std::vector<Run>& fine);

}  // namespace pentimento::conservative
