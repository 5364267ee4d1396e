#pragma once
// Solves z x - div(c grad x) = rhs (multigrid_rows.h) on a part of a grid, its runs, by a fixed
// number of V-cycles. It never takes a norm and sums nothing over the grid, so the result is a
// fixed expression of the input: the same bits for any number of threads.
//
// Nodes beyond the runs hold zeros on all planes: set_runs() sets them. The couplings to them are
// 0.

#include <array>
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

  // The system on the finest grid. The caller fills these planes over the runs, before solve() or
  // by Job::fill.
  WorkPlane& cx() { return levels_[0].cx; }
  WorkPlane& cy() { return levels_[0].cy; }
  WorkPlane& zero_order() { return levels_[0].z; }
  WorkPlane& rhs() { return levels_[0].rhs; }
  WorkPlane& solution() { return levels_[0].x; }

  /// Sets the nodes to solve for, by rows; both rows of a coarse one have the same. Writes zeros on
  /// all planes of all levels over the nodes that were among them before and are not now.
  void set_runs(const std::vector<Run>& runs);
  /// Gives back the memory of all planes of all levels, over the fine nodes [x0, x1) x [y0, y1),
  /// where they hold zeros.
  void give_back(int x0, int x1, int y0, int y1);
  /// How many levels a system with couplings up to `coupling` (without unit, z = 1) needs: on each
  /// next level they are 4 times weaker, and at 0.3 sweeps alone do. At most as many as there are
  /// grids.
  int levels_for(float coupling) const;
  /// Work on a run of a row that goes along with the solve, while the row is in the cache.
  using RowWork = std::function<void(const Run& run)>;
  /// What the caller knows of a system, and what it does along with the solution.
  struct Job {
    const WorkPlane* guess = nullptr;  // the first guess; nullptr: what solution() holds
    bool unit_zero_order = false;      // z is 1 everywhere, and zero_order() is not read
    /// Stages that fill the system. When a stage is called on a row, the stage before it is done on
    /// that row and on both neighbour rows.
    std::vector<RowWork> fill = {};
    /// Called on a row once the result is there, on that row and on both neighbour rows.
    RowWork finish = {};
  };
  /// Does `cycles` V-cycles over `levels` >= 1 grids, with two Jacobi sweeps on the way down and
  /// two on the way up.
  void solve(int cycles, int levels, const Threads& threads, const Job& job);

 private:
  struct Level {
    WorkPlane cx, cy, z, inverse, rhs, x, other;
    RunIndex index;           // those that passes go over: `filled`, by whole vectors
    std::vector<Run> filled;  // nodes that the next finer grid writes its system and residual to
    const float* ones = nullptr;  // in place of every row of z; nullptr: z is read

    std::array<WorkPlane*, 7> planes() { return {&cx, &cy, &z, &inverse, &rhs, &x, &other}; }
    const float* z_row(int y) const { return ones != nullptr ? ones : z.row(y); }
  };
  Level& level(int l) { return levels_[static_cast<std::size_t>(l)]; }
  void prepare(int levels, const Threads& threads);
  void coarse_cycle(int l, int levels, const Threads& threads);
  void start(const Job& job, bool and_restrict, const Threads& threads);
  void go_on(bool and_descend, const RowWork& finish, const Threads& threads);
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
