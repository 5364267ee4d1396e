#include "core/fluid/paper/trace.h"

#include <gtest/gtest.h>

#include <cstring>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "core/fluid/paper/planes.h"
#include "tests/core/fluid/paper/canvases.h"

namespace pentimento::paper {
namespace {

constexpr int kWidth = 150, kHeight = 9;

struct Traced {
  Traced() : u(kWidth), v(kWidth), height(kWidth), mobility(kWidth, kHeight) {}
  TracedRow row() { return {u.data(), v.data(), height.data(), mobility}; }
  std::vector<float> u, v, height;
  Field<float> mobility;
};

bool same_bits(const float* a, const float* b, Columns cells) {
  return std::memcmp(a + cells.begin, b + cells.begin, cells.count() * sizeof(float)) == 0;
}

/// Bare cells, cells of thin film and of thick, in stripes.
void lay_stripes(CanvasState& state, float dry_film_m) {
  std::uint32_t n = 0;
  const auto share = [&] { return random_uniform(RandomPurpose::kBristle, 4, ++n); };
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const int stripe = (x / 3 + y) % 3;
      state.depth_m(x, y) = stripe == 0   ? 0
                            : stripe == 1 ? dry_film_m * share()
                                          : dry_film_m * (1 + 9 * share());
      state.base_m(x, y) = 0.0003f * share();
    }
}

// The oracle: cell by cell. All paint drifts so many cells, and each cell of its own besides; there
// are still cells among them. Thin films take the mobility of thick ones that come.
TEST(Trace, VectorsGiveTheBitsOfSingleCells) {
  const std::vector<std::pair<float, float>> flows = {{0, 0.3f}, {0, 1},     {0, 1.999f}, {0, 7},
                                                      {5, 0.4f}, {-4.5f, 1}, {-3, 0.01f}};
  int taken = 0;  // mobilities
  for (const auto& flow : flows) {
    const float drift_cells = flow.first, fastest_cells = flow.second;
    TestCanvas canvas(kWidth, kHeight);
    const StepInput in{canvas.model,   canvas.gravity, canvas.dt_s,
                       canvas.contact, canvas.amount,  canvas.threads};
    const StepConstants k = make_step_constants(canvas.state.geometry, in);
    lay_stripes(canvas.state, k.dry_film_m);
    std::uint32_t n = 0;
    const auto share = [&] { return random_uniform(RandomPurpose::kBristle, 5, ++n); };
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const float u = drift_cells + (2 * share() - 1) * fastest_cells;
        const float v = drift_cells + (2 * share() - 1) * fastest_cells;
        canvas.state.velocity_x_m_s(x, y) = x % 4 == 0 ? 0 : u * k.dx_m / k.dt_s;
        canvas.state.velocity_y_m_s(x, y) = x % 8 == 0 ? 0 : v * k.dy_m / k.dt_s;
      }
    for (const Columns cells : {Columns{0, kWidth}, Columns{1, 2}, Columns{3, 140}}) {
      Traced near, plain;
      for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) near.mobility(x, y) = plain.mobility(x, y) = share();
      const Field<float> before = plain.mobility.clone();
      for (int y = 0; y < kHeight; ++y) {
        trace_row(k, canvas.state, y, cells, near.row());
        trace_cells(k, canvas.state, y, cells, plain.row());
        ASSERT_TRUE(same_bits(near.u.data(), plain.u.data(), cells)) << y << " " << drift_cells;
        ASSERT_TRUE(same_bits(near.v.data(), plain.v.data(), cells)) << y << " " << drift_cells;
        ASSERT_TRUE(same_bits(near.height.data(), plain.height.data(), cells))
            << y << " " << drift_cells;
      }
      for (int y = 0; y < kHeight; ++y) {
        ASSERT_TRUE(same_bits(near.mobility.row(y), plain.mobility.row(y), {0, kWidth})) << y;
        for (int x = 0; x < kWidth; ++x) taken += plain.mobility(x, y) != before(x, y) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(taken, 500);
}

// Half the way to the neighbour upstream: the mean of both, and of cells that are not square the
// share of their own width.
TEST(Trace, BringsWhatWasAStepAgo) {
  TestCanvas canvas(kWidth, kHeight);
  canvas.state.geometry.height_m *= 2;
  const StepInput in{canvas.model,   canvas.gravity, canvas.dt_s,
                     canvas.contact, canvas.amount,  canvas.threads};
  const StepConstants k = make_step_constants(canvas.state.geometry, in);
  canvas.state.base_m.fill(0);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      canvas.state.depth_m(x, y) =
          0.001f + 0.0001f * static_cast<float>(x) + 0.001f * static_cast<float>(y);
  canvas.state.velocity_x_m_s.fill(0.5f * k.dx_m / k.dt_s);
  canvas.state.velocity_y_m_s.fill(-0.25f * k.dy_m / k.dt_s);
  Traced traced;
  trace_row(k, canvas.state, 4, {0, kWidth}, traced.row());
  for (const int x : {1, 2, 70, 148}) {
    const float expected = 0.001f + 0.0001f * (static_cast<float>(x) - 0.5f) + 0.001f * 4.25f;
    EXPECT_NEAR(traced.height[static_cast<std::size_t>(x)], expected, 1e-7f) << x;
    EXPECT_FLOAT_EQ(traced.u[static_cast<std::size_t>(x)], canvas.state.velocity_x_m_s(x, 4));
  }
}

}  // namespace
}  // namespace pentimento::paper
