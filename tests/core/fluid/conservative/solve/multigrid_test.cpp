#include "core/fluid/conservative/solve/multigrid.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pentimento::conservative {
namespace {

/// A system like a step's height equation: couplings 0 .. 2 `strength`, with walls and islands.
struct Rough {
  Rough(int width, int height, float strength) : w(width), h(height), solver(width, height) {
    std::vector<conservative::Run> runs;
    for (int y = 0; y < h; ++y) runs.push_back({y, 0, w});
    solver.set_runs(runs);
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x) {
        solver.zero_order().row(y)[x] = 1;
        solver.rhs().row(y)[x] =
            std::sin(0.13f * static_cast<float>(x * y)) + 0.01f * static_cast<float>(x);
        solver.cx().row(y)[x] = x + 1 < w ? coupling(x, y, strength) : 0.0f;
        solver.cy().row(y)[x] = y + 1 < h ? coupling(x, y, strength) : 0.0f;
      }
  }
  static float coupling(int a, int b, float strength) {
    const float wave =
        std::sin(0.21f * static_cast<float>(a)) + std::cos(0.17f * static_cast<float>(b));
    return wave < -0.8f ? 0.0f : strength * (1 + 0.5f * wave);
  }
  double residual() {
    double sum = 0;
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x) {
        const auto u = [&](int i, int j) {
          return static_cast<double>(solver.solution().row(j)[i]);
        };
        const auto cx = [&](int i) { return static_cast<double>(solver.cx().row(y)[i]); };
        const auto cy = [&](int j) { return static_cast<double>(solver.cy().row(j)[x]); };
        const double r = static_cast<double>(solver.rhs().row(y)[x]) - u(x, y) -
                         cx(x) * (u(x, y) - u(x + 1, y)) - cx(x - 1) * (u(x, y) - u(x - 1, y)) -
                         cy(y) * (u(x, y) - u(x, y + 1)) - cy(y - 1) * (u(x, y) - u(x, y - 1));
        sum += r * r;
      }
    return std::sqrt(sum);
  }
  int w, h;
  Multigrid solver;
};

TEST(Multigrid, FiveCyclesLeaveLittleOfTheResidual) {
  // From 0, at the coupling of 5 cm of paint on a 1024-cell canvas (254) and far weaker, with
  // islands of no coupling, which cost a cycle or two: measured 5e-7, 6e-5 and 6e-4.
  for (const float strength : {1.0f, 20.0f, 250.0f}) {
    Rough rough(150, 110, strength);
    const double before = rough.residual();
    rough.solver.solve(5, rough.solver.levels_for(2 * strength), Threads(), {});
    EXPECT_LT(rough.residual(), 1e-3 * before) << strength;
  }
}

/// Couplings that are everywhere `coupling`, on 64 x 64 nodes, and the right side `rhs(x, y)`.
template <typename Rhs>
Rough even_system(float coupling, const Rhs& rhs) {
  Rough even(64, 64, 0);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      even.solver.cx().row(y)[x] = x < 63 ? coupling : 0.0f;
      even.solver.cy().row(y)[x] = y < 63 ? coupling : 0.0f;
      even.solver.rhs().row(y)[x] = rhs(x, y);
    }
  return even;
}

TEST(Multigrid, ACycleLeavesAFortiethOfTheShortestWave) {
  // No coarser grid sees it, so the four sweeps do it all: 1 / T4(5/3) = 1 / 40.5 is left at the
  // end of the spectrum, by the definition of Chebyshev's polynomial. 2e-4: the spectrum ends at 2
  // less 1 / 4000, and there T4 falls by 16 / 0.75 for each unit, which makes 1.3e-4.
  Rough even = even_system(1000, [](int x, int y) { return (x + y) % 2 == 0 ? 1.0f : -1.0f; });
  even.solver.solve(1, 3, Threads(), {});
  const float exact = 1.0f / 8001;
  EXPECT_NEAR(even.solver.solution().row(32)[32] / exact, 1 - 1 / 40.5f, 2e-4f);
}

TEST(Multigrid, ACycleOfWeakCouplingsHasAllItsSweeps) {
  // At 0.25 the scaled operator's spectrum ends at 1/2 and 3/2, where a fortieth is left at most;
  // two sweeps would leave a third of the longest waves.
  Rough even = even_system(0.25f, [](int x, int) { return 1 + 0.1f * static_cast<float>(x); });
  const double before = even.residual();
  even.solver.solve(1, even.solver.levels_for(0.25f), Threads(), {});
  EXPECT_LT(even.residual(), before / 40);
}

TEST(Multigrid, FinishSeesTheSolutionOfEachRunOnce) {
  for (const int cycles : {1, 2, 3})
    for (const int levels : {1, 2, 4}) {
      Rough rough(96, 80, 1);
      std::vector<int> calls(80, 0);
      std::vector<float> middle(80, 0);
      const auto finish = [&](const auto& r) {
        ++calls[static_cast<std::size_t>(r.y)];
        middle[static_cast<std::size_t>(r.y)] = rough.solver.solution().row(r.y)[48];
      };
      Multigrid::Job job;
      job.finish = finish;
      rough.solver.solve(cycles, levels, Threads(), job);
      for (int y = 0; y < 80; ++y) {
        EXPECT_EQ(calls[static_cast<std::size_t>(y)], 1) << cycles << ", " << levels;
        EXPECT_EQ(middle[static_cast<std::size_t>(y)], rough.solver.solution().row(y)[48]);
      }
    }
}

TEST(Multigrid, NodesThatAreNoneMayBeLeftOut) {
  // Two squares of nodes, 8 nodes from one another; on the first coarse grid they share a vector.
  const auto is_node = [](int x, int y) {
    return (x < 16 || (x >= 24 && x < 40)) && y >= 4 && y < 20;
  };
  const auto solved = [&](bool leave_out) {
    Multigrid solver(96, 24);
    std::vector<conservative::Run> runs;
    for (int y = 0; y < 24; ++y) {
      if (!leave_out) runs.push_back({y, 0, 96});
      if (leave_out && is_node(0, y)) {
        runs.push_back({y, 0, 16});
        runs.push_back({y, 24, 40});
      }
    }
    solver.set_runs(runs);
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 96; ++x) {
        if (!is_node(x, y)) continue;
        solver.zero_order().row(y)[x] = 1;
        solver.rhs().row(y)[x] = std::sin(0.3f * static_cast<float>(x + 7 * y));
        solver.cx().row(y)[x] = x + 1 < 96 && is_node(x + 1, y) ? 40.0f : 0.0f;
        solver.cy().row(y)[x] = is_node(x, y + 1) ? 40.0f : 0.0f;
      }
    solver.solve(2, 5, Threads(), {});
    return solver;
  };
  Multigrid all = solved(false), some = solved(true);
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 96; ++x)
      EXPECT_EQ(all.solution().row(y)[x], some.solution().row(y)[x]) << x << " " << y;
  EXPECT_NE(some.solution().row(10)[10], 0);
  // What was left in nodes that are none any more is forgotten.
  some.set_runs({{4, 0, 16}});
  EXPECT_EQ(some.solution().row(10)[10], 0);
  EXPECT_EQ(some.rhs().row(10)[30], 0);
}

TEST(Multigrid, SolvesATinySystemByHand) {
  // Two nodes, coupling 1: (1 + 1) a - b = 3, (1 + 1) b - a = 0 gives a = 2, b = 1.
  Multigrid solver(2, 1);
  solver.set_runs({{0, 0, 2}});
  solver.zero_order().row(0)[0] = solver.zero_order().row(0)[1] = 1;
  solver.cx().row(0)[0] = 1;
  solver.rhs().row(0)[0] = 3;
  solver.solve(12, 1, Threads(), {});
  EXPECT_NEAR(solver.solution().row(0)[0], 2.0f, 1e-5f);
  EXPECT_NEAR(solver.solution().row(0)[1], 1.0f, 1e-5f);
}

TEST(Multigrid, SolvesARowOnItsOwn) {
  // The last row of an odd number belongs to a coarse row of its own; here it is all there is.
  // Sweeps alone leave a tenth and more of such a coupling.
  Rough rough(256, 1, 250);
  const double before = rough.residual();
  rough.solver.solve(5, rough.solver.levels_for(500), Threads(), {});
  EXPECT_LT(rough.residual(), 3e-3 * before);
}

}  // namespace
}  // namespace pentimento::conservative
