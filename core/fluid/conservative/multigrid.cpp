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
  levels_[0].runs = runs;
  for (std::size_t l = 1; l < levels_.size(); ++l)
    levels_[l].runs = coarsen_runs(levels_[l - 1].runs);
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
    Level& level = levels_[static_cast<std::size_t>(l)];
    if (l > 0) {
      const Level& fine = levels_[static_cast<std::size_t>(l - 1)];
      for_runs(threads, level.runs, [&](const Run& r) {
        const int x = 2 * r.x0;
        const int y = 2 * r.y;
        const float* upper_z = fine.z.row(y) + x;
        restrict_row(upper_z, fine.z.row(y + 1) + x, r.size(), level.z.row(r.y) + r.x0);
        coarsen_cx_row(fine.cx.row(y) + x, fine.cx.row(y + 1) + x, r.size(),
                       level.cx.row(r.y) + r.x0);
        coarsen_cy_row(fine.cy.row(y + 1) + x, r.size(), level.cy.row(r.y) + r.x0);
      });
    }
    for_runs(threads, level.runs, [&](const Run& r) {
      inverse_diagonal_row(stencil_at(level.cx, level.cy, r.x0, r.y), level.z.row(r.y) + r.x0,
                           r.size(), level.inverse.row(r.y) + r.x0);
    });
  }
}

void Multigrid::smooth(Level& level, const Threads& threads) {
  const auto sweep = [&](const WorkPlane& from, WorkPlane& to, float weight) {
    for_runs(threads, level.runs, [&](const Run& r) {
      smooth_row(stencil_at(level.cx, level.cy, r.x0, r.y), level.inverse.row(r.y) + r.x0,
                 level.rhs.row(r.y) + r.x0, nodes_at(from, r.x0, r.y), weight, r.size(),
                 to.row(r.y) + r.x0);
    });
  };
  sweep(level.x, level.other, kWeightA);
  sweep(level.other, level.x, kWeightB);
}

void Multigrid::smooth_from_zero(Level& level, const Threads& threads) {
  for_runs(threads, level.runs, [&](const Run& r) {
    smooth_zero_row(level.inverse.row(r.y) + r.x0, level.rhs.row(r.y) + r.x0, kWeightA, r.size(),
                    level.other.row(r.y) + r.x0);
  });
  for_runs(threads, level.runs, [&](const Run& r) {
    smooth_row(stencil_at(level.cx, level.cy, r.x0, r.y), level.inverse.row(r.y) + r.x0,
               level.rhs.row(r.y) + r.x0, nodes_at(level.other, r.x0, r.y), kWeightB, r.size(),
               level.x.row(r.y) + r.x0);
  });
}

void Multigrid::restrict_residual(Level& fine, Level& coarse, const Threads& threads) {
  for_runs(threads, fine.runs, [&](const Run& r) {
    residual_row(stencil_at(fine.cx, fine.cy, r.x0, r.y), fine.z.row(r.y) + r.x0,
                 fine.rhs.row(r.y) + r.x0, nodes_at(fine.x, r.x0, r.y), r.size(),
                 fine.other.row(r.y) + r.x0);
  });
  for_runs(threads, coarse.runs, [&](const Run& r) {
    restrict_row(fine.other.row(2 * r.y) + 2 * r.x0, fine.other.row(2 * r.y + 1) + 2 * r.x0,
                 r.size(), coarse.rhs.row(r.y) + r.x0);
  });
}

void Multigrid::add_correction(Level& fine, Level& coarse, const Threads& threads) {
  for_runs(threads, fine.runs, [&](const Run& r) {
    const int y = r.y / 2;
    const int over = (r.y & 1) != 0 ? y + 1 : y - 1;
    const int x = r.x0 / 2;
    const int start = 2 * x;  // prolong_row starts at an even node
    const ProlongRow c{coarse.x.row(y) + x, coarse.x.row(over) + x, coarse.cx.row(y) + x,
                       coarse.cy.row(over < y ? over : y) + x};
    prolong_row(c, stencil_at(fine.cx, fine.cy, start, r.y), r.x1 - start, fine.x.row(r.y) + start);
  });
}

void Multigrid::cycle(int l, int levels, const Threads& threads) {
  Level& level = levels_[static_cast<std::size_t>(l)];
  if (l == 0)
    smooth(level, threads);
  else
    smooth_from_zero(level, threads);
  if (l + 1 < levels) {
    Level& coarse = levels_[static_cast<std::size_t>(l + 1)];
    restrict_residual(level, coarse, threads);
    cycle(l + 1, levels, threads);
    add_correction(level, coarse, threads);
  }
  smooth(level, threads);
}

void Multigrid::solve(int cycles, int levels, const Threads& threads) {
  prepare(levels, threads);
  for (int k = 0; k < cycles; ++k) cycle(0, levels, threads);
}

}  // namespace pentimento::conservative
