// The detail canvas: its motion, levelling and lock on a fine canvas that is wet all over, and
// whole strokes at growing detail. One thread.
//   build/pentimento_bench --benchmark_filter='^Detail'

#include <benchmark/benchmark.h>

#include <array>

#include "core/detail/flow/advect_detail.h"
#include "core/detail/flow/level_detail.h"
#include "core/detail/lock/lock.h"
#include "core/fluid/brush_contact.h"
#include "tests/bench/least_time.h"
#include "tests/core/detail/painted.h"

namespace pentimento {
namespace {

constexpr int kFactor = 8, kWidth = 96, kHeight = 72;  // 768 x 576 fine cells
constexpr double kFineCells = kWidth * kHeight * kFactor * kFactor;
constexpr int kRepeats = 8;  // enough to be told from noise, quick to be repeated

void report(benchmark::State& run, const LeastTime& least) {
  least.report(run, kFineCells);
  run.SetItemsProcessed(run.iterations() * kWidth * kHeight * kFactor * kFactor);
}

/// A guide of cells of a millimetre under runny paint in two layers of two pigments, and its detail
/// canvas, whose cells all differ.
struct FineCanvas {
  FineCanvas() : guide(make_canvas_state(layout.guide(), 2, 2, 3, 1.0f)), edges(layout.guide(), 2) {
    guide.depth_m.fill(0.002f);
    for (Field<float>& plane : guide.pigment) plane.fill(0.001f);
    for (int t = 0; t < layout.tiles(); ++t) {
      canvas.ensure_planes(t, guide);
      DetailTile& tile = *canvas.find(t);
      for (int i = 0; i < layout.side() * layout.side(); ++i) {
        const float grain = 1 + 0.001f * static_cast<float>(i % 331);
        tile.depth_m.data()[i] = 0.002f * grain;
        for (TilePlane& plane : tile.pigment) plane.data()[i] = 0.001f * grain;
      }
    }
    all.add({0, kWidth, 0, kHeight});
  }
  /// Edges that move to and fro, a quarter of a guide cell at most.
  void move_edges(float sign) {
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const float cells = 0.05f * static_cast<float>((x * 3 + y * 5) % 6);
        edges.x[0](x, y) = x + 1 < kWidth ? sign * cells : 0;
        edges.y[0](x, y) = y + 1 < kHeight ? sign * cells : 0;
      }
  }

  const DetailLayout layout{{kWidth, kHeight, 1e-3 * kWidth, 1e-3 * kHeight}, kFactor};
  CanvasState guide;
  PaintEdges edges;
  test::PlainSubstrate substrate;
  std::unique_ptr<TileStore> store =
      std::move(*TileStore::open({static_cast<std::size_t>(layout.side() * layout.side()), "", 0}));
  DetailCanvas canvas{layout, 2, 2, 3, substrate, *store};
  ChangedBlocks all{layout};
  std::array<float, 2> amount = {1, 1};
  Threads threads{1};
};

void move(benchmark::State& run, Axis axis) {
  FineCanvas c;
  float sign = 1;
  LeastTime least;
  for (auto _ : run) {
    c.move_edges(sign);
    least.time([&] { advect_detail(c.canvas, c.edges, axis, c.all, {0, c.amount}, c.threads); });
    sign = -sign;
  }
  report(run, least);
}
void DetailMoveX(benchmark::State& run) {
  move(run, Axis::kX);
}
void DetailMoveY(benchmark::State& run) {
  move(run, Axis::kY);
}

void DetailLevel(benchmark::State& run) {
  FineCanvas c;
  c.move_edges(1);
  const Model model;
  const BrushContact contact = make_brush_contact(kWidth, kHeight);
  const std::vector<float> amount = {1, 1};
  const StepInput in{model, {0, -4, 9}, 1.0f / 45, contact, amount, c.threads};
  LeastTime least;
  for (auto _ : run) least.time([&] { level_detail(c.canvas, c.guide, c.edges, in, c.all); });
  report(run, least);
}

/// The guide's paint grows and shrinks by a fiftieth and is never the same in two cells side by
/// side, so every block has ratios to find.
void DetailLock(benchmark::State& run) {
  FineCanvas c;
  Lock lock(c.layout);
  bool more = true;
  LeastTime least;
  for (auto _ : run) {
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const float factor = ((x + y) % 2 == 0) == more ? 1.02f : 1 / 1.02f;
        c.guide.depth_m(x, y) *= factor;
        for (Field<float>& plane : c.guide.pigment) plane(x, y) *= factor;
      }
    least.time([&] { lock.lock(c.canvas, c.guide, c.all.strips(), c.threads); });
    more = !more;
  }
  report(run, least);
}

BENCHMARK(DetailMoveX)->Iterations(kRepeats)->Unit(benchmark::kMillisecond);
BENCHMARK(DetailMoveY)->Iterations(kRepeats)->Unit(benchmark::kMillisecond);
BENCHMARK(DetailLevel)->Iterations(kRepeats)->Unit(benchmark::kMillisecond);
BENCHMARK(DetailLock)->Iterations(kRepeats)->Unit(benchmark::kMillisecond);

/// Three crossing strokes on a guide of 256 x 192 cells, with all that the detail canvas does.
/// Argument: the detail.
void DetailStrokes(benchmark::State& run) {
  for (auto _ : run) {
    test::Painted painted(256, static_cast<int>(run.range(0)));
    painted.cross();
    painted.follower().finish_stamps();
  }
}
BENCHMARK(DetailStrokes)
    ->Arg(1)
    ->Arg(2)
    ->Arg(4)
    ->Arg(8)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pentimento
