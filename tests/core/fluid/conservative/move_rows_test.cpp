#include <gtest/gtest.h>

#include "core/fluid/conservative/advection/advection.h"
#include "tests/core/fluid/conservative/basin.h"
#include "tests/core/fluid/conservative/plain_momentum.h"
#include "tests/core/fluid/conservative/plain_paint.h"

namespace pentimento::conservative {
namespace {

// Three layers of patchy paint of five channels with a bare half, moving at `speed` cells a step at
// most, and a brush in the middle.
Basin moving(float speed) {
  Basin b({600, 150, 0.6, 0.15}, 3, 5);
  b.amount = {1, 0.5f, 1, 2, 0.25f};
  const float to_m_s = 1e-3f / b.dt_s;
  for (int y = 0; y < 150; ++y)
    for (int x = 0; x < 600; ++x) {
      const float wave = 0.5f + 0.5f * std::sin(0.11f * static_cast<float>(x * (1 + y % 3)));
      const float d = x % 37 < 5 ? 0.0f : 0x1p-26f * std::floor(6e5f * wave);
      b.state.depth_m(x, y) = d;
      for (int k = 0; k < 3; ++k)
        for (int c = 0; c < 5; ++c)
          if (x < 300 || k == 0)
            b.state.channel(k, c)(x, y) =
                c == 2 ? 0 : 0x1p-22f * std::floor(4e4f * wave) * (1 + y % 2);
      const auto phase = static_cast<float>(x + 3 * y);
      b.state.velocity_x_m_s(x, y) = speed * to_m_s * std::sin(0.3f * phase);
      b.state.velocity_y_m_s(x, y) = speed * to_m_s * std::cos(0.17f * phase);
      if (y < 60 || y > 80 || x < 200 || x > 260) continue;
      b.contact.push_x_m(x, y) = 4e-4f;
      b.contact.push_y_m(x, y) = (x < 230 ? 3e-4f : -3e-4f) * wave;
    }
  b.contact.touch(200, 261, 60, 81);
  return b;
}

class Edges : public AdvectionListener {
 public:
  explicit Edges(const Basin& b) : edges_(b.state.geometry, b.state.layers) {}
  PaintEdges& edges() override { return edges_; }
  void moved(const CanvasState&, const StepInput&, const std::vector<Run>&) override {}

 private:
  PaintEdges edges_;
};

void expect_same_edges(PaintEdges& a, PaintEdges& b) {
  for (std::size_t q = 0; q < a.x.size(); ++q)
    for (int y = 0; y < 150; ++y)
      for (int x = 0; x < 600; ++x) {
        ASSERT_EQ(a.x[q](x, y), b.x[q](x, y)) << q << " " << x << " " << y;
        ASSERT_EQ(a.y[q](x, y), b.y[q](x, y)) << q << " " << x << " " << y;
      }
}

// 0.1: no cell goes far. 0.7: some edges cross. 3: many cells go far, and crowd.
class MoveRows : public testing::TestWithParam<float> {};
INSTANTIATE_TEST_SUITE_P(Speeds, MoveRows, testing::Values(0.0f, 0.1f, 0.7f, 3.0f));

TEST_P(MoveRows, PaintLandsWhereThePlainTwinPutsIt) {
  for (const Axis axis : {Axis::kX, Axis::kY})
    for (const bool followed : {false, true}) {
      Basin fast = moving(GetParam());
      Basin plain = moving(GetParam());
      Edges fast_edges(fast), plain_edges(plain);
      for (Basin* b : {&fast, &plain}) {
        Edges& edges = b == &fast ? fast_edges : plain_edges;
        const StepInput in{b->model,
                           b->gravity_m_s2,
                           b->dt_s,
                           b->contact,
                           b->amount,
                           b->pool,
                           followed ? &edges : nullptr};
        SleepTiles tiles(b->state.geometry, b->model.sleep_tile_m);
        tiles.wake(b->state, in);
        WetCells wet;
        wet.find_all(tiles);
        if (b == &fast)
          advect_paint(b->state, in, axis, wet);
        else
          advect_paint_in_batches(b->state, in, axis, wet);
      }
      EXPECT_TRUE(same_bits(fast.state.depth_m, plain.state.depth_m));
      for (std::size_t k = 0; k < fast.state.pigment.size(); ++k)
        EXPECT_TRUE(same_bits(fast.state.pigment[k], plain.state.pigment[k])) << k;
      expect_same_edges(fast_edges.edges(), plain_edges.edges());
    }
}

// Both turns, in either order, so that each axis is the first and the second.
TEST_P(MoveRows, MomentumGoesWhereThePlainTwinPutsIt) {
  Basin b = moving(GetParam());
  const auto expect_same = [](const WorkPlane& a, const WorkPlane& c) {
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x) ASSERT_EQ(a.row(y)[x], c.row(y)[x]) << x << " " << y;
  };
  for (const bool superbee : {false, true})
    for (const Axis first : {Axis::kX, Axis::kY}) {
      b.model.superbee = superbee;
      const StepInput in{b.model, b.gravity_m_s2, b.dt_s, b.contact, b.amount, b.pool};
      SleepTiles tiles(b.state.geometry, b.model.sleep_tile_m);
      tiles.wake(b.state, in);
      WetCells wet;
      wet.find_all(tiles);
      Workspace fast(b.state.geometry), plain(b.state.geometry);
      for (Workspace* w : {&fast, &plain}) fill_node_masses(b.state, wet, b.pool, *w);
      for (const Turn turn : {Turn::kFirst, Turn::kSecond}) {
        const bool along_x = (first == Axis::kX) == (turn == Turn::kFirst);
        const Axis axis = along_x ? Axis::kX : Axis::kY;
        advect_momentum(b.state, in, axis, turn, wet, fast);
        advect_momentum_in_batches(b.state, in, axis, turn, wet, plain);
      }
      expect_same(fast.x.mass_m, plain.x.mass_m);
      expect_same(fast.y.mass_m, plain.y.mass_m);
      expect_same(fast.x.velocity_m_s, plain.x.velocity_m_s);
      expect_same(fast.y.velocity_m_s, plain.y.velocity_m_s);
    }
}

}  // namespace
}  // namespace pentimento::conservative
