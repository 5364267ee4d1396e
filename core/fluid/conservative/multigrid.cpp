#include "core/fluid/conservative/multigrid.h"

#include "core/fluid/conservative/multigrid_rows.h"

namespace pentimento::conservative {
namespace {

// Roots of the degree 2 Chebyshev polynomial on [1/2, 2], the part of the scaled operator's
// spectrum (0, 2) that a coarser grid does not see: 5/4 +- (3/4) sqrt(1/2).
constexpr float kWeightA = 1 / (1.25f + 0.53033009f);
constexpr float kWeightB = 1 / (1.25f - 0.53033009f);

StencilRow stencil_at(const WorkPlane& cx, const WorkPlane& cy, int x, int y) {
  return {cx.row(y) + x, cy.row(y - 1) + x, cy.row(y) + x};
}
NodeRow nodes_at(const WorkPlane& plane, int x, int y) {
  return {plane.row(y - 1) + x, plane.row(y) + x, plane.row(y + 1) + x};
}

// The passes over one run of a level. Sweeps write `x` and `other` in turn.
template <typename Level>
void sweep(const Level& l, const Run& r, const WorkPlane& from, WorkPlane& to, float weight) {
  smooth_row(stencil_at(l.cx, l.cy, r.x0, r.y), l.inverse.row(r.y) + r.x0, l.rhs.row(r.y) + r.x0,
             nodes_at(from, r.x0, r.y), weight, r.size(), to.row(r.y) + r.x0);
}
template <typename Level>
void first_sweep_from_zero(Level& l, const Run& r) {
  smooth_zero_row(l.inverse.row(r.y) + r.x0, l.rhs.row(r.y) + r.x0, kWeightA, r.size(),
                  l.other.row(r.y) + r.x0);
}
template <typename Level>
void leave_residual(Level& l, const Run& r) {
  residual_row(stencil_at(l.cx, l.cy, r.x0, r.y), l.z.row(r.y) + r.x0, l.rhs.row(r.y) + r.x0,
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
  prolong_row(c, stencil_at(fine.cx, fine.cy, start, r.y), r.x1 - start, fine.x.row(r.y) + start);
}

}  // namespace

Multigrid::Multigrid(int width, int height) {
  for (int w = width, h = height;; w = (w + 1) / 2, h = (h + 1) / 2) {
    Level& level = levels_.emplace_back();
    for (WorkPlane* p :
         {&level.cx, &level.cy, &level.z, &level.inverse, &level.rhs, &level.x, &level.other})
      *p = WorkPlane(w, h);
    if (w <= 2 && h <= 2) break;
  }
}

void Multigrid::set_runs(const std::vector<Run>& runs) {
  std::vector<Run> here = runs;
  for (Level& level : levels_) {
    std::vector<Run> coarser = coarsen_runs(here);
    level.index = RunIndex(std::move(here), level.x.height());
    here = std::move(coarser);
  }
}

void Multigrid::clear(int x0, int x1, int y0, int y1) {
  for (Level& level : levels_) {
    for (WorkPlane* p :
         {&level.cx, &level.cy, &level.z, &level.inverse, &level.rhs, &level.x, &level.other})
      p->clear(x0, x1, y0, y1);
    x0 /= 2;
    y0 /= 2;
    x1 = (x1 + 1) / 2;
    y1 = (y1 + 1) / 2;
  }
}

int Multigrid::levels_for(float coupling) const {
  int levels = 1;
  for (; coupling > 0.3f && levels < static_cast<int>(levels_.size()); coupling /= 4) ++levels;
  return levels;
}

void Multigrid::prepare(int levels, const Threads& threads) {
  for (int l = 0; l < levels; ++l) {
    Level& here = level(l);
    if (l > 0) {
      const Level& fine = level(l - 1);
      for_runs(threads, here.index.runs(), [&](const Run& r) {
        const int x = 2 * r.x0;
        const int y = 2 * r.y;
        restrict_row(fine.z.row(y) + x, fine.z.row(y + 1) + x, r.size(), here.z.row(r.y) + r.x0);
        coarsen_cx_row(fine.cx.row(y) + x, fine.cx.row(y + 1) + x, r.size(),
                       here.cx.row(r.y) + r.x0);
        coarsen_cy_row(fine.cy.row(y + 1) + x, r.size(), here.cy.row(r.y) + r.x0);
      });
    }
    for_runs(threads, here.index.runs(), [&](const Run& r) {
      inverse_diagonal_row(stencil_at(here.cx, here.cy, r.x0, r.y), here.z.row(r.y) + r.x0,
                           r.size(), here.inverse.row(r.y) + r.x0);
    });
  }
}

// Smooths the first guess and leaves the residual in `other`.
void Multigrid::start(Level& fine, const Threads& threads) {
  for_bands(threads, fine.index, fine.x.width(), 4, [&](int stage, const Run& r) {
    if (stage == 1) sweep(fine, r, fine.x, fine.other, kWeightA);
    if (stage == 2) sweep(fine, r, fine.other, fine.x, kWeightB);
    if (stage == 3) leave_residual(fine, r);
  });
}

// The same from a first guess of 0.
void Multigrid::descend(Level& here, const Threads& threads) {
  for_bands(threads, here.index, here.x.width(), 3, [&](int stage, const Run& r) {
    if (stage == 0) first_sweep_from_zero(here, r);
    if (stage == 1) sweep(here, r, here.other, here.x, kWeightB);
    if (stage == 2) leave_residual(here, r);
  });
}

void Multigrid::bottom(Level& here, const Threads& threads) {
  for_bands(threads, here.index, here.x.width(), 4, [&](int stage, const Run& r) {
    if (stage == 0) first_sweep_from_zero(here, r);
    if (stage == 1) sweep(here, r, here.other, here.x, kWeightB);
    if (stage == 2) sweep(here, r, here.x, here.other, kWeightA);
    if (stage == 3) sweep(here, r, here.other, here.x, kWeightB);
  });
}

// Adds the coarse correction and smooths; then, if asked, what start() does.
void Multigrid::ascend(Level& here, Level& coarse, bool and_descend, const Threads& threads) {
  for_bands(threads, here.index, here.x.width(), and_descend ? 6 : 3, [&](int stage, const Run& r) {
    if (stage == 0) add_correction(here, coarse, r);
    if (stage == 1 || stage == 3) sweep(here, r, here.x, here.other, kWeightA);
    if (stage == 2 || stage == 4) sweep(here, r, here.other, here.x, kWeightB);
    if (stage == 5) leave_residual(here, r);
  });
}

void Multigrid::restrict_residual(const Level& fine, Level& coarse, const Threads& threads) {
  for_runs(threads, coarse.index.runs(), [&](const Run& r) {
    restrict_row(fine.other.row(2 * r.y) + 2 * r.x0, fine.other.row(2 * r.y + 1) + 2 * r.x0,
                 r.size(), coarse.rhs.row(r.y) + r.x0);
  });
}

void Multigrid::coarse_cycle(int l, int levels, const Threads& threads) {
  restrict_residual(level(l - 1), level(l), threads);
  if (l + 1 == levels) return bottom(level(l), threads);
  descend(level(l), threads);
  coarse_cycle(l + 1, levels, threads);
  ascend(level(l), level(l + 1), false, threads);
}

void Multigrid::solve(int cycles, int levels, const Threads& threads) {
  prepare(levels, threads);
  if (levels == 1) {  // weak coupling: sweeps alone
    for (int k = 0; k < cycles; ++k) start(level(0), threads);
    return;
  }
  start(level(0), threads);
  for (int k = 0; k < cycles; ++k) {
    coarse_cycle(1, levels, threads);
    ascend(level(0), level(1), k + 1 < cycles, threads);
  }
}

}  // namespace pentimento::conservative
