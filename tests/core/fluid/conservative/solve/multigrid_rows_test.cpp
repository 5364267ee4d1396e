#include "core/fluid/conservative/solve/multigrid_rows.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace pentimento::conservative {
namespace {

constexpr int kNodes = 77;  // no whole number of vectors of any length

/// Rows of nodes with one more at each side, all of other values.
struct Rows {
  explicit Rows(float shift) : values(kNodes + 2) {
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = 1.1f + std::sin(0.37f * static_cast<float>(i) + shift);
  }
  const float* at() const { return values.data() + 1; }
  std::vector<float> values;
};

TEST(MultigridRows, TheFirstSweepIsTheInverseDiagonalAndASweep) {
  Rows cx(1), above(2), cy(3), z(4), rhs(5), up(6), here(7), down(8);
  for (const std::size_t node : {9u, 10u}) {  // 9 stands alone, 10 is none
    cx.values[node] = cx.values[node + 1] = above.values[node + 1] = cy.values[node + 1] = 0;
    z.values[11] = 0;
  }
  cx.values[9] = cx.values[11] = 0;
  const StencilRow a{cx.at(), above.at(), cy.at()};
  const NodeRow x{up.at(), here.at(), down.at()};
  std::array<std::vector<float>, 2> inverse, out;
  for (std::size_t k : {0u, 1u}) {
    inverse[k].assign(kNodes, -1);
    out[k].assign(kNodes, -1);
  }
  inverse_diagonal_row(a, z.at(), kNodes, inverse[0].data());
  smooth_row(a, inverse[0].data(), rhs.at(), x, 0.65f, kNodes, out[0].data());
  first_smooth_row(a, z.at(), rhs.at(), x, 0.65f, kNodes, inverse[1].data(), out[1].data());
  EXPECT_EQ(inverse[0], inverse[1]);
  EXPECT_EQ(out[0], out[1]);
  EXPECT_EQ(inverse[0][10], 0) << "no node";
  EXPECT_FLOAT_EQ(inverse[0][9], 1 / z.at()[9]) << "alone";
}

TEST(MultigridRows, ACorrectionGoesToNodesThatAreTied) {
  // Coarse nodes 0 .. 3 with a wall between 1 and 2; what lies over them is the same.
  const std::array<float, 6> coarse{9, 1, 2, 4, 8, 9};
  const std::array<float, 6> joined{0, 1, 0, 1, 0, 0};
  const std::array<float, 6> over{1, 1, 1, 1, 1, 1};
  std::array<float, 8> inverse{0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 1, 0, 0.5f};
  std::array<float, 8> x{};
  prolong_row({coarse.data() + 1, coarse.data() + 1, joined.data() + 1, over.data() + 1},
              inverse.data(), 8, x.data());
  // Half of the own, a quarter of the one over it (the same), a quarter of the nearer one beside.
  EXPECT_EQ(x[0], 1) << "no node to the left";
  EXPECT_EQ(x[1], 0.75f * 1 + 0.25f * 2);
  EXPECT_EQ(x[2], 0.75f * 2 + 0.25f * 1);
  EXPECT_EQ(x[3], 2) << "a wall to the right";
  EXPECT_EQ(x[4], 4) << "and from there";
  EXPECT_EQ(x[5], 0) << "alone";
  EXPECT_EQ(x[6], 0) << "none";
  EXPECT_EQ(x[7], 8);
}

}  // namespace
}  // namespace pentimento::conservative
