#include "core/fluid/conservative/solve/multigrid.h"

#include <algorithm>

#include "core/base/fetch_ahead.h"
#include "core/fluid/conservative/solve/multigrid_rows.h"
#include "core/fluid/conservative/tiles/wet_cells.h"

namespace pentimento::conservative {
namespace {

// Weights of the four sweeps of a V-cycle: inverse roots of the Chebyshev polynomial of degree 4 on
// [1/2, 2], 1 / (5/4 +- (3/4) cos(3 pi/8)) on the way down and 1 / (5/4 +- (3/4) cos(pi/8)) on the
// way up. That interval is the part of the scaled operator's spectrum (0, 2) that a coarser grid
// does not see; of each of its errors a fortieth is left at most. The outer roots come last, for
// prolongation leaves the shortest waves.
constexpr float kDownA = 1 / (1.25f + 0.28701257f);
constexpr float kDownB = 1 / (1.25f - 0.28701257f);
constexpr float kUpA = 1 / (1.25f + 0.69290965f);
constexpr float kUpB = 1 / (1.25f - 0.69290965f);

StencilRow stencil_at(const WorkPlane& cx, const WorkPlane& cy, int x, int y) {
  return {cx.row(y) + x, cy.row(y - 1) + x, cy.row(y) + x};
}
NodeRow nodes_at(const WorkPlane& plane, int x, int y) {
  return {plane.row(y - 1) + x, plane.row(y) + x, plane.row(y + 1) + x};
}

// The passes over one run of a level. Smoothing sweeps write the planes `x` and `other` in turn.
template <typename Level>
void sweep(const Level& l, const Run& r, const WorkPlane& from, WorkPlane& to, float weight) {
  smooth_row(stencil_at(l.cx, l.cy, r.x0, r.y), l.inverse.row(r.y) + r.x0, l.rhs.row(r.y) + r.x0,
             nodes_at(from, r.x0, r.y), weight, r.size(), to.row(r.y) + r.x0);
}
template <typename Level>
void first_sweep(Level& l, const Run& r, const WorkPlane& guess) {
  first_smooth_row(stencil_at(l.cx, l.cy, r.x0, r.y), l.z_row(r.y) + r.x0, l.rhs.row(r.y) + r.x0,
                   nodes_at(guess, r.x0, r.y), kDownA, r.size(), l.inverse.row(r.y) + r.x0,
                   l.other.row(r.y) + r.x0);
}
template <typename Level>
void first_sweep_from_zero(Level& l, const Run& r) {
  smooth_zero_row(l.inverse.row(r.y) + r.x0, l.rhs.row(r.y) + r.x0, kDownA, r.size(),
                  l.other.row(r.y) + r.x0);
}
template <typename Level>
void leave_residual(Level& l, const Run& r) {
  residual_row(stencil_at(l.cx, l.cy, r.x0, r.y), l.z_row(r.y) + r.x0, l.rhs.row(r.y) + r.x0,
               nodes_at(l.x, r.x0, r.y), r.size(), l.other.row(r.y) + r.x0);
}
template <typename Level>
void add_correction(Level& fine, const Level& coarse, const Run& r) {
  const int y = r.y / 2;
  const int over = (r.y & 1) != 0 ? y + 1 : y - 1;
  const int x = r.x0 / 2;
  const int start = 2 * x;  // prolong_row starts at an even node
  const ProlongRow c{coarse.x.row(y) + x, coarse.x.row(over) + x, coarse.cx.row(y) + x,
                     coarse.cy.row(over < y ? over : y) + x};
  prolong_row(c, fine.inverse.row(r.y) + start, r.x1 - start, fine.x.row(r.y) + start);
}

template <typename Level>
void invert_diagonal(Level& l, const Run& r) {
  inverse_diagonal_row(stencil_at(l.cx, l.cy, r.x0, r.y), l.z_row(r.y) + r.x0, r.size(),
                       l.inverse.row(r.y) + r.x0);
}
// Asks for the system of a row that the sweeps come to soon.
template <typename Level>
void fetch_system(const Level& l, const Run& r) {
  const int y = r.y + kRowsAhead;
  if (y >= l.x.height()) return;
  for (const WorkPlane* plane : {&l.cx, &l.cy, &l.inverse, &l.rhs, &l.x, &l.other})
    fetch_ahead(plane->row(y) + r.x0, r.size());
}
// Restriction to a run of the coarse level: first the system, then the residual, which is the right
// side there.
template <typename Level>
void coarsen(const Level& fine, Level& coarse, const Run& r) {
  const int x = 2 * r.x0;
  const int y = 2 * r.y;
  if (coarse.ones == nullptr)
    restrict_row(fine.z.row(y) + x, fine.z.row(y + 1) + x, r.size(), coarse.z.row(r.y) + r.x0);
  coarsen_cx_row(fine.cx.row(y) + x, fine.cx.row(y + 1) + x, r.size(), coarse.cx.row(r.y) + r.x0);
  coarsen_cy_row(fine.cy.row(y + 1) + x, r.size(), coarse.cy.row(r.y) + r.x0);
}
template <typename Level>
void restrict_residual(const Level& fine, Level& coarse, const Run& r) {
  restrict_row(fine.other.row(2 * r.y) + 2 * r.x0, fine.other.row(2 * r.y + 1) + 2 * r.x0, r.size(),
               coarse.rhs.row(r.y) + r.x0);
}

// Runs that begin and end at whole vectors, or at the end of a row of `width` nodes. What they
// cover besides holds zeros, and is left so.
std::vector<Run> whole_vectors(const std::vector<Run>& runs, int width) {
  constexpr int kVector = 16;
  std::vector<Run> out;
  for (const Run& r : runs) {
    const int x0 = r.x0 / kVector * kVector;
    const int x1 = std::min((r.x1 + kVector - 1) / kVector * kVector, width);
    if (!out.empty() && out.back().y == r.y && out.back().x1 >= x0)
      out.back().x1 = x1;
    else
      out.push_back({r.y, x0, x1});
  }
  return out;
}

}  // namespace

Multigrid::Multigrid(int width, int height) : ones_(static_cast<std::size_t>(width), 1.0f) {
  for (int w = width, h = height;; w = (w + 1) / 2, h = (h + 1) / 2) {
    Level& level = levels_.emplace_back();
    const auto planes = level.planes();
    PlaneMemory memory = WorkPlane::memory_for(static_cast<int>(planes.size()), w, h);
    for (WorkPlane* p : planes) *p = WorkPlane(w, h, memory);
    if (w <= 2 && h <= 2) break;
  }
}

void Multigrid::set_runs(const std::vector<Run>& runs) {
  std::vector<Run> filled = runs;
  for (Level& level : levels_) {
    for_cells_left(level.filled, filled, [&](int y, int x0, int x1) {
      for (WorkPlane* p : level.planes()) p->clear(x0, x1, y, y + 1);
    });
    std::vector<Run> here =
        &level == &levels_.front() ? filled : whole_vectors(filled, level.x.width());
    level.filled = std::move(filled);
    filled = coarsen_runs(here);
    level.index = RunIndex(std::move(here), level.x.height());
  }
}

void Multigrid::give_back(int x0, int x1, int y0, int y1) {
  for (Level& level : levels_) {
    if (x0 >= x1 || y0 >= y1) return;
    for (WorkPlane* p : level.planes()) p->give_back(x0, x1, y0, y1);
    // The coarse nodes of these fine ones alone.
    x0 = (x0 + 1) / 2;
    y0 = (y0 + 1) / 2;
    x1 /= 2;
    y1 /= 2;
  }
}

int Multigrid::levels_for(float coupling) const {
  int levels = 1;
  for (; coupling > 0.3f && levels < static_cast<int>(levels_.size()); coupling /= 4) ++levels;
  return levels;
}

// Builds the systems of the coarser grids. start() has already built the first of them, all but its
// diagonal.
void Multigrid::prepare(int levels, const Threads& threads) {
  for (int l = 1; l < levels; ++l) {
    Level& here = level(l);
    if (l > 1) {
      const Level& fine = level(l - 1);
      for_runs(threads, here.index.runs(), [&](const Run& r) { coarsen(fine, here, r); });
    }
    for_runs(threads, here.index.runs(), [&](const Run& r) { invert_diagonal(here, r); });
  }
}

// Whether fine run `r` lies in the last row that belongs to its coarse row. The row above it has
// the same runs (set_runs).
bool Multigrid::below_coarse_row(const Run& r) const {
  return (r.y & 1) != 0 || r.y + 1 == levels_[0].x.height();
}

void Multigrid::coarsen_system(const Run& r) {
  if (below_coarse_row(r)) coarsen(level(0), level(1), {r.y / 2, r.x0 / 2, (r.x1 + 1) / 2});
}

void Multigrid::coarsen_residual(const Run& r) {
  if (below_coarse_row(r))
    restrict_residual(level(0), level(1), {r.y / 2, r.x0 / 2, (r.x1 + 1) / 2});
}

// The way down on the finest grid: fills the system and smooths the first guess. If `and_restrict`,
// it also leaves the residual in `other`, and system and residual on the next grid.
void Multigrid::start(const Job& job, bool and_restrict, const Threads& threads) {
  Level& fine = level(0);
  const std::vector<RowWork>& fill = job.fill;
  const WorkPlane& guess = job.guess != nullptr ? *job.guess : fine.x;
  const int filled = std::max(1, static_cast<int>(fill.size()));
  for_stages(threads, fine.index, filled + (and_restrict ? 4 : 2), [&](int stage, const Run& r) {
    if (stage == 0) fetch_system(fine, r);
    // The caller's stages fill the system.
    if (stage < static_cast<int>(fill.size())) fill[static_cast<std::size_t>(stage)](r);
    // Smoothing: two sweeps from the guess, and the inverse diagonal along with the first.
    if (stage == filled) first_sweep(fine, r, guess);
    if (stage == filled + 1) sweep(fine, r, fine.other, fine.x, kDownB);
    // What the sweeps left to do goes to the next grid.
    if (stage == filled + 2) leave_residual(fine, r);
    if (stage != filled + 3) return;
    coarsen_system(r);
    coarsen_residual(r);
  });
}

// The sweeps of the way up on the finest grid, for systems that need no coarser one. Then those of
// the way down of the next cycle (`and_descend`), or the caller's `finish`, if any.
void Multigrid::go_on(bool and_descend, const RowWork& finish, const Threads& threads) {
  Level& fine = level(0);
  const int stages = and_descend ? 5 : finish ? 4 : 3;
  for_stages(threads, fine.index, stages, [&](int stage, const Run& r) {
    if (stage == 1) sweep(fine, r, fine.x, fine.other, kUpA);
    if (stage == 2) sweep(fine, r, fine.other, fine.x, kUpB);
    if (stage == 3 && !and_descend) finish(r);
    if (stage == 3 && and_descend) sweep(fine, r, fine.x, fine.other, kDownA);
    if (stage == 4) sweep(fine, r, fine.other, fine.x, kDownB);
  });
}

// The way down on a coarser grid: two sweeps from a guess of 0, then the residual.
void Multigrid::descend(Level& here, const Threads& threads) {
  for_stages(threads, here.index, 3, [&](int stage, const Run& r) {
    if (stage == 0) first_sweep_from_zero(here, r);
    if (stage == 1) sweep(here, r, here.other, here.x, kDownB);
    if (stage == 2) leave_residual(here, r);
  });
}

void Multigrid::bottom(Level& here, const Threads& threads) {
  for_stages(threads, here.index, 4, [&](int stage, const Run& r) {
    if (stage == 0) first_sweep_from_zero(here, r);
    if (stage == 1) sweep(here, r, here.other, here.x, kDownB);
    if (stage == 2) sweep(here, r, here.x, here.other, kUpA);
    if (stage == 3) sweep(here, r, here.other, here.x, kUpB);
  });
}

// The way up: adds the correction of the coarser grid and smooths it. On the finest grid it is
// followed by the way down of the next V-cycle (`and_descend`), or by the caller's `finish` after
// the last one.
void Multigrid::ascend(int l, bool and_descend, const RowWork& finish, const Threads& threads) {
  Level& here = level(l);
  const Level& coarse = level(l + 1);
  const int stages = and_descend ? 7 : finish ? 4 : 3;
  for_stages(threads, here.index, stages, [&](int stage, const Run& r) {
    // Prolongation, then two sweeps: the end of this V-cycle.
    if (stage == 0) fetch_system(here, r);
    if (stage == 0) add_correction(here, coarse, r);
    if (stage == 1) sweep(here, r, here.x, here.other, kUpA);
    if (stage == 2) sweep(here, r, here.other, here.x, kUpB);
    // Either the caller's last stage, or the start of the next V-cycle: two sweeps, then the
    // residual.
    if (stage == 3 && !and_descend) finish(r);
    if (stage == 3 && and_descend) sweep(here, r, here.x, here.other, kDownA);
    if (stage == 4) sweep(here, r, here.other, here.x, kDownB);
    if (stage == 5) leave_residual(here, r);
    if (stage == 6) coarsen_residual(r);
  });
}

void Multigrid::coarse_cycle(int l, int levels, const Threads& threads) {
  if (l > 1)
    for_runs(threads, level(l).index.runs(),
             [&](const Run& r) { restrict_residual(level(l - 1), level(l), r); });
  // On the coarsest grid four sweeps do: its couplings are weak (levels_for).
  if (l + 1 == levels) return bottom(level(l), threads);
  descend(level(l), threads);
  coarse_cycle(l + 1, levels, threads);
  ascend(l, false, {}, threads);
}

void Multigrid::solve(int cycles, int levels, const Threads& threads, const Job& job) {
  const RowWork& finish = job.finish;
  for (Level& l : levels_) l.ones = job.unit_zero_order ? ones_.data() : nullptr;
  // The system, and the way down of the first V-cycle.
  start(job, levels > 1, threads);
  if (levels == 1) {  // the coupling is so weak that sweeps alone do
    for (int k = 0; k < cycles; ++k) go_on(k + 1 < cycles, finish, threads);
    return;
  }
  // The coarser systems are built once; then each V-cycle goes through them and up again.
  prepare(levels, threads);
  for (int k = 0; k < cycles; ++k) {
    coarse_cycle(1, levels, threads);
    ascend(0, k + 1 < cycles, finish, threads);
  }
}

}  // namespace pentimento::conservative
