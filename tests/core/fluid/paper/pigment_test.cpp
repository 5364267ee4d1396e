// R18 and R19.

#include "core/fluid/paper/pigment.h"

#include <gtest/gtest.h>

#include <cstring>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "tests/core/fluid/paper/canvases.h"

namespace pentimento::paper {
namespace {

TEST(Pigment, LayersMoveWithTheirDepth) {
  EXPECT_FLOAT_EQ(layer_velocity_frac(0, 1), 0.5f);
  EXPECT_FLOAT_EQ(layer_velocity_frac(0, 4), 0.125f);
  EXPECT_FLOAT_EQ(layer_velocity_frac(3, 4), 0.875f);
  EXPECT_FLOAT_EQ(layer_velocity_frac(1, 2), 0.75f);
  EXPECT_FLOAT_EQ(layer_velocity_frac(0, 0), 0.5f);  // arriving on empty canvas
  EXPECT_FLOAT_EQ(layer_velocity_frac(1, 0), 0.75f);
}

/// A canvas with an edge in each of two layers at x = 20, ready to be traced with 1024 u / 45
/// cells.
struct Edge {
  Edge() : canvas(48, 3), planes(make_planes(48, 3, 2)) {
    canvas.pour(0, 0, 20, 3, 0.01f, 0.2f, 0);
    canvas.pour(0, 0, 20, 3, 0.01f, 0.2f, 1);
    planes.occupied.fill(2);
    u.assign(48, 8 * 45 / 1024.0f);  // the surface moves 8 cells
    v.assign(48, 0);
  }
  float traced(int layer, int x, float residue) {
    canvas.model.pigment_residue = residue;
    const StepInput in{canvas.model,   canvas.gravity, canvas.dt_s,
                       canvas.contact, canvas.amount,  canvas.threads};
    const StepConstants k = make_step_constants(canvas.state.geometry, in);
    for (int y = 0; y < 3; ++y)
      find_free_row(canvas.state, canvas.amount, residue, y, {0, 48}, planes);
    advect_pigment_row(k, canvas.state, layer, u.data(), v.data(), 1, {0, 48}, planes);
    return planes.pigment[0](x, 1);
  }
  TestCanvas canvas;
  Planes planes;
  std::vector<float> u, v;
};

TEST(Pigment, ArrivesFromUpstreamAtTheSpeedOfItsLayer) {
  Edge edge;  // of two layers the lower moves 2 cells, the upper 6
  EXPECT_FLOAT_EQ(edge.traced(0, 21, 0), 0.2f);
  EXPECT_EQ(edge.traced(0, 23, 0), 0);
  EXPECT_FLOAT_EQ(edge.traced(1, 25, 0), 0.2f);
  EXPECT_EQ(edge.traced(1, 27, 0), 0);
}

TEST(Pigment, CountsTheLayersThatHoldAny) {
  TestCanvas canvas(300, 1, 3, 2);
  canvas.state.channel(0, 1)(299, 0) = 0.1f;
  canvas.state.channel(2, 0)(299, 0) = 0.1f;
  canvas.state.channel(1, 0)(5, 0) = 0.1f;
  Planes planes = make_planes(300, 1, 2);
  count_layers_row(canvas.state, 0, {0, 300}, planes);
  EXPECT_EQ(planes.occupied(299, 0), 2);
  EXPECT_EQ(planes.occupied(5, 0), 1);
  EXPECT_EQ(planes.occupied(6, 0), 0);
}

TEST(Pigment, TheResidueStaysInTheBottomLayer) {
  Edge edge;
  for (int x = 0; x < 20; ++x) edge.u[static_cast<std::size_t>(x)] *= -1;  // emptied to the left
  EXPECT_NEAR(edge.traced(0, 19, 0.01f), 0.01f, 1e-8);                     // one rounding of 0.2
  EXPECT_EQ(edge.traced(1, 19, 0.01f), 0);
  EXPECT_EQ(edge.traced(0, 30, 0.01f), 0);  // none where no pigment has been
}

TEST(Pigment, AFaintLayerSticksWhole) {
  Edge edge;
  edge.canvas.pour(0, 0, 20, 3, 0.01f, 0.008f, 0);
  EXPECT_FLOAT_EQ(edge.traced(0, 19, 0.01f), 0.008f);
  EXPECT_EQ(edge.traced(0, 20, 0.01f), 0);
}

TEST(Pigment, TheResidueOutlastsAnyFlow) {
  TestCanvas canvas(32, 64);
  canvas.pour(8, 8, 24, 24, 0.003f, 0.03f);
  canvas.gravity = {0, -9.81f, 0};
  canvas.steps(100);
  const float least = 0.99f * canvas.model.pigment_residue;  // a hundred steps of rounding
  float lowest = 1;
  for (int y = 8; y < 24; ++y)
    for (int x = 8; x < 24; ++x) lowest = std::min(lowest, canvas.state.channel(0, 0)(x, y));
  EXPECT_GE(lowest, least);
  EXPECT_LT(lowest, 0.03f / 2);  // and most of it did leave
}

// The oracle: cell by cell. All paint drifts so many cells, and each cell of its own besides, up to
// a cell and beyond; there are still cells among them.
TEST(Pigment, VectorsGiveTheBitsOfSingleCells) {
  constexpr int kWidth = 150, kHeight = 9;
  const std::vector<std::pair<float, float>> flows = {
      {0, 0.3f}, {0, 1}, {0, 1.999f}, {0, 2}, {0, 7}, {5, 0.4f}, {-4.5f, 1}, {-3, 0.01f}};
  for (const auto& flow : flows) {
    const float drift_cells = flow.first, fastest_cells = flow.second;
    TestCanvas canvas(kWidth, kHeight);
    std::uint32_t n = 0;
    const auto share = [&] { return random_uniform(RandomPurpose::kBristle, 9, ++n); };
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        for (Field<float>& plane : canvas.state.pigment)
          plane(x, y) = (x / 5 + y) % 3 == 0 ? 0 : (x % 7 == 0 ? 2e-9f : 0.1f) * share();
    Planes near = make_planes(kWidth, kHeight, canvas.state.channels);
    Planes plain = make_planes(kWidth, kHeight, canvas.state.channels);
    const StepInput in{canvas.model,   canvas.gravity, canvas.dt_s,
                       canvas.contact, canvas.amount,  canvas.threads};
    const StepConstants k = make_step_constants(canvas.state.geometry, in);
    const float cell_m_s = k.dx_m / k.dt_s;
    for (Planes* planes : {&near, &plain})
      for (int y = 0; y < kHeight; ++y) {
        find_free_row(canvas.state, canvas.amount, 0.02f, y, {0, kWidth}, *planes);
        count_layers_row(canvas.state, y, {0, kWidth}, *planes);
      }
    for (int layer = 0; layer < canvas.state.layers; ++layer)
      for (int y = 0; y < kHeight; ++y) {
        std::vector<float> u(kWidth), v(kWidth);
        for (std::size_t x = 0; x < u.size(); ++x) {
          const auto any = [&] {
            return (drift_cells + (2 * share() - 1) * fastest_cells) * cell_m_s;
          };
          u[x] = x % 4 == 0 ? 0 : any();
          v[x] = x % 8 == 0 ? 0 : any();
          if (x % 11 == 5) u[x] = (drift_cells - fastest_cells) * cell_m_s;  // just so far
        }
        for (const Columns cells : {Columns{0, kWidth}, Columns{1, 2}, Columns{3, 140}}) {
          advect_pigment_row(k, canvas.state, layer, u.data(), v.data(), y, cells, near);
          advect_pigment_cells(k, canvas.state, layer, u.data(), v.data(), y, cells, plain);
          for (std::size_t c = 0; c < near.pigment.size(); ++c)
            ASSERT_EQ(
                std::memcmp(near.pigment[c].row(y) + cells.begin,
                            plain.pigment[c].row(y) + cells.begin, cells.count() * sizeof(float)),
                0)
                << "layer " << layer << ", row " << y << ", " << drift_cells << " and "
                << fastest_cells << " cells";
        }
      }
  }
}

// Planes that take the place of a layer's hold what would have been copied to it.
TEST(Pigment, ExchangedPlanesHoldWhatIsStored) {
  constexpr int kWide = 70, kHigh = 3;
  TestCanvas stored(kWide, kHigh), exchanged(kWide, kHigh);
  Planes planes = make_planes(kWide, kHigh, 2);
  std::uint32_t n = 0;
  const auto share = [&] { return random_uniform(RandomPurpose::kBristle, 6, ++n); };
  for (int c = 0; c < 2; ++c)
    for (int y = 0; y < kHigh; ++y)
      for (int x = 0; x < kWide; ++x) {
        stored.state.channel(1, c)(x, y) = exchanged.state.channel(1, c)(x, y) = share();
        planes.pigment[static_cast<std::size_t>(c)](x, y) = share();
      }
  const std::vector<Columns> flow = {{3, 60}, {}, {0, kWide}};  // of each row
  for (int y = 0; y < kHigh; ++y) {
    const Columns cells = flow[static_cast<std::size_t>(y)];
    const bool changed = store_pigment_row(planes, 1, y, cells, stored.state);
    EXPECT_EQ(changed, !cells.empty());
    EXPECT_EQ(complete_pigment_row(exchanged.state, 1, y, cells, planes), changed);
  }
  exchange_pigment(1, exchanged.state, planes);
  for (int c = 0; c < 2; ++c)
    EXPECT_TRUE(paper::same_bits(stored.state.channel(1, c), exchanged.state.channel(1, c)));
  // What now lies there differs nowhere from itself.
  for (int y = 0; y < kHigh; ++y)
    EXPECT_FALSE(complete_pigment_row(stored.state, 1, y, {}, planes));
}

}  // namespace
}  // namespace pentimento::paper
