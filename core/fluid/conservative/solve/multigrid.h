#pragma once
// Solves z x - div(c grad x) = rhs (multigrid_rows.h) on the awake part of a grid by a fixed number
// of V-cycles. No norm is ever taken and nothing is summed over the grid, so the result is a fixed
// expression of the input: the same bits for any number of threads.
//
// What is asleep must hold zeros on all planes: clear() does it. Couplings to nodes asleep are 0.

#include <functional>
#include <vector>

#include "core/base/threads.h"
#include "core/fluid/conservative/solve/stages.h"
#include "core/fluid/conservative/solve/work_plane.h"

namespace pentimento::conservative {

class Multigrid {
 public:
  /// Planes for a grid and its coarser versions.
  Multigrid(int width, int height);

  // The system on the finest grid: the caller fills these over the runs before solve().
  WorkPlane& cx() { return levels_[0].cx; }
  WorkPlane& cy() { return levels_[0].cy; }
  WorkPlane& zero_order() { return levels_[0].z; }
  WorkPlane& rhs() { return levels_[0].rhs; }
  WorkPlane& solution() { return levels_[0].x; }

  /// The nodes to solve for, by rows.
  void set_runs(const std::vector<Run>& runs);
  /// Zeros on all planes of all levels over the fine nodes [x0, x1) x [y0, y1).
  void clear(int x0, int x1, int y0, int y1);
  /// Levels needed for couplings up to `coupling`: 4 times weaker on each, down to 0.3.
  int levels_for(float coupling) const;
  /// Work on a run of a row that goes along with the solve, while the row is in the cache.
  using RowWork = std::function<void(const Run& run)>;
  /// What is known of a system, and what is done along with its solution.
  struct Job {
    const WorkPlane* guess = nullptr;  // the first guess; none: what solution() holds
    bool unit_zero_order = false;      // z is 1 everywhere, and zero_order() is not read
    /// Fills the system, one after the other: when one is done on a row, those before it are done
    /// on that row and on both its neighbours.
    std::vector<RowWork> fill = {};
    /// Done on a row when the result is there on it and on both its neighbours.
    RowWork finish = {};
  };
  /// `cycles` V-cycles over `levels` >= 1 grids: two Jacobi sweeps before and after.
  void solve(int cycles, int levels, const Threads& threads, const Job& job);

 private:
  struct Level {
    WorkPlane cx, cy, z, inverse, rhs, x, other;
    RunIndex index;
    const float* ones = nullptr;  // in place of every row of z, or none

    const float* z_row(int y) const { return ones != nullptr ? ones : z.row(y); }
  };
  Level& level(int l) { return levels_[static_cast<std::size_t>(l)]; }
  void prepare(int levels, const Threads& threads);
  void coarse_cycle(int l, int levels, const Threads& threads);
  void start(const Job& job, bool and_restrict, const Threads& threads);
  void go_on(const RowWork& finish, const Threads& threads);
  void coarsen_system(const Run& fine_run);
  void coarsen_residual(const Run& fine_run);
  bool below_coarse_row(const Run& r) const;
  void descend(Level& here, const Threads& threads);
  void bottom(Level& here, const Threads& threads);
  void ascend(int l, bool and_descend, const RowWork& finish, const Threads& threads);

  std::vector<Level> levels_;
  std::vector<float> ones_;
};

}  // namespace pentimento::conservative
