// What a step of the conservative scheme costs with the whole canvas awake, pass by pass, beside
// the paper scheme's; and moving paint and momentum beside their plain twins. The probe of
// probe_bench.cpp belongs to the same run:
//   build/pentimento_bench --benchmark_filter='Conservative|Probe' --benchmark_repetitions=3
// Counter ns_per_cell: per awake cell and step.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "core/fluid/conservative/advection/advection.h"
#include "core/simulation/make_scheme.h"
#include "tests/bench/least_time.h"
#include "tests/bench/running_canvas.h"
#include "tests/core/fluid/conservative/plain_momentum.h"
#include "tests/core/fluid/conservative/plain_paint.h"

namespace pentimento::conservative {
namespace {

constexpr int kWidth = 1024, kHeight = 768;
constexpr double kCells = kWidth * kHeight;
constexpr int kSteps = 12, kMoves = 8;  // enough to be told from noise, quick to be repeated

void report(benchmark::State& state) {
  state.counters["ns_per_cell"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * kWidth * kHeight * 1e-9,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.SetItemsProcessed(state.iterations() * kWidth * kHeight);
}

// The least processor time of each pass in any step, of all threads together.
class PassClock {
 public:
  void begin() { since_ = std::clock(); }
  void passed(const char* name) {
    const std::clock_t now = std::clock();
    auto at = std::find_if(ns_.begin(), ns_.end(), [&](const auto& p) { return p.first == name; });
    if (at == ns_.end()) at = ns_.insert(at, {name, std::numeric_limits<double>::infinity()});
    const double ns = 1e9 / CLOCKS_PER_SEC * static_cast<double>(now - since_);
    at->second = std::min(at->second, ns);
    since_ = now;
  }
  void report(benchmark::State& state) const {
    for (const auto& [name, ns] : ns_) state.counters["ns_" + name] = ns / kCells;
  }

 private:
  std::vector<std::pair<std::string, double>> ns_;
  std::clock_t since_ = 0;
};

void ConservativeStep(benchmark::State& state) {
  Basin b = running_canvas(kWidth, kWidth, static_cast<int>(state.range(0)));
  PassClock clock;
  int step = 0;
  double awake = 1;
  int parts = 0;
  b.scheme.on_pass([&](const char* pass) {
    clock.passed(pass);
    if (std::string_view(pass) == "height") ++parts;
  });
  for (auto _ : state) {
    turn(b, step++);
    clock.begin();
    b.step();
    awake = std::min(awake, b.scheme.awake_share());
  }
  state.counters["awake_min"] = awake;
  state.counters["parts"] = static_cast<double>(parts) / step;  // into which a step is cut
  state.counters["speed"] = b.statistic("max_speed_m_s");
  clock.report(state);
  report(state);
}
/// The same with and without surface tension, and with films that end: bare stripes, 24 cells of
/// each 48. Arguments: whether films end, N/m in thousandths.
void ConservativeTension(benchmark::State& state) {
  Basin b = running_canvas(kWidth, kWidth, 1);
  b.model.surface_tension_N_m = 1e-3f * static_cast<float>(state.range(1));
  if (state.range(0) != 0) {
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        if (x / 24 % 2 == 0) continue;
        b.state.depth_m(x, y) = 0;
        for (Field<float>& plane : b.state.pigment) plane(x, y) = 0;
      }
    }
  }
  PassClock clock;
  b.scheme.on_pass([&](const char* pass) { clock.passed(pass); });
  int step = 0;
  for (auto _ : state) {
    turn(b, step++);
    clock.begin();
    b.step();
  }
  clock.report(state);
  report(state);
}
BENCHMARK(ConservativeTension)
    ->ArgsProduct({{0, 1}, {0, 32}})
    ->Iterations(12)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

BENCHMARK(ConservativeStep)
    ->Arg(1)
    ->Arg(2)
    ->Iterations(kSteps)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

using MovePaint = void (*)(CanvasState&, const StepInput&, Axis, const WetCells&);
/// Moves the paint forth and back, so that it stays what it is. Arguments: axis, threads.
void move_paint(benchmark::State& state, MovePaint move) {
  Basin b = running_canvas(kWidth, kWidth, static_cast<int>(state.range(1)));
  const Axis axis = state.range(0) == 0 ? Axis::kX : Axis::kY;
  SleepTiles tiles(b.state.geometry, b.model.sleep_tile_m);
  b.state.sleep.clear();
  const StepInput forth{b.model, b.gravity_m_s2, b.dt_s, b.contact, b.amount, b.pool};
  const StepInput back{b.model, b.gravity_m_s2, -b.dt_s, b.contact, b.amount, b.pool};
  tiles.wake(b.state, forth);
  WetCells wet;
  wet.find_all(tiles);
  bool forward = true;
  LeastTime least;
  for (auto _ : state) {
    least.time([&] { move(b.state, forward ? forth : back, axis, wet); });
    forward = !forward;
  }
  least.report(state, kCells);
  report(state);
}
void ConservativeMovePaint(benchmark::State& state) {
  move_paint(state, advect_paint);
}
void ConservativeMovePaintPlainly(benchmark::State& state) {
  move_paint(state, advect_paint_in_batches);
}
BENCHMARK(ConservativeMovePaint)
    ->ArgsProduct({{0, 1}, {1, 2}})
    ->Iterations(kMoves)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(ConservativeMovePaintPlainly)
    ->ArgsProduct({{0, 1}, {1}})
    ->Iterations(kMoves)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

using MoveMomentum = void (*)(const CanvasState&, const StepInput&, Axis, Turn, const WetCells&,
                              Workspace&);
/// Arguments: axis, threads.
void move_momentum(benchmark::State& state, MoveMomentum move) {
  Basin b = running_canvas(kWidth, kWidth, static_cast<int>(state.range(1)));
  const Axis axis = state.range(0) == 0 ? Axis::kX : Axis::kY;
  SleepTiles tiles(b.state.geometry, b.model.sleep_tile_m);
  Workspace work(b.state.geometry);
  b.state.sleep.clear();
  const StepInput in{b.model, b.gravity_m_s2, b.dt_s, b.contact, b.amount, b.pool};
  tiles.wake(b.state, in);
  WetCells wet;
  wet.find_all(tiles);
  fill_node_masses(b.state, wet, b.pool, work);
  LeastTime least;
  for (auto _ : state) least.time([&] { move(b.state, in, axis, Turn::kFirst, wet, work); });
  least.report(state, kCells);
  report(state);
}
void ConservativeMoveMomentum(benchmark::State& state) {
  move_momentum(state, advect_momentum);
}
void ConservativeMoveMomentumPlainly(benchmark::State& state) {
  move_momentum(state, advect_momentum_in_batches);
}
BENCHMARK(ConservativeMoveMomentum)
    ->ArgsProduct({{0, 1}, {1, 2}})
    ->Iterations(kMoves)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(ConservativeMoveMomentumPlainly)
    ->ArgsProduct({{0, 1}, {1}})
    ->Iterations(kMoves)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void ConservativeVCycle(benchmark::State& state) {
  Multigrid solver(kWidth, kHeight);
  std::vector<Run> runs;
  for (int y = 0; y < kHeight; ++y) runs.push_back({y, 0, kWidth});
  solver.set_runs(runs);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      solver.zero_order().row(y)[x] = 1;
      solver.rhs().row(y)[x] = static_cast<float>((x * y) % 7);
      solver.cx().row(y)[x] = x + 1 < kWidth ? 50.0f : 0.0f;
      solver.cy().row(y)[x] = y + 1 < kHeight ? 50.0f : 0.0f;
    }
  const Threads threads(static_cast<int>(state.range(0)));
  LeastTime least;
  for (auto _ : state) least.time([&] { solver.solve(1, 6, threads, {}); });
  least.report(state, kCells);
  report(state);
}
BENCHMARK(ConservativeVCycle)
    ->Arg(1)
    ->Arg(2)
    ->Iterations(20)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void ConservativePaperStep(benchmark::State& state) {
  Basin b = running_canvas(kWidth, kWidth, static_cast<int>(state.range(0)));
  b.model.scheme = SchemeKind::kPaper;
  const auto scheme = make_scheme(SchemeKind::kPaper, b.state.geometry, 2, 4);
  const StepInput in{b.model, b.gravity_m_s2, b.dt_s, b.contact, b.amount, b.pool};
  for (auto _ : state) scheme->step(b.state, in);
  report(state);
}
BENCHMARK(ConservativePaperStep)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace pentimento::conservative
