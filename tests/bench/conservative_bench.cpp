// What a step of the conservative scheme costs with the whole canvas awake, pass by pass, beside
// the paper scheme's plain loops and a memory probe in the same run.
//   build/pentimento_bench --benchmark_filter=Conservative --benchmark_repetitions=3
// Counter ns_per_cell: per awake cell and step.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <string>

#include "core/fluid/conservative/advection/advection.h"
#include "core/simulation/make_scheme.h"
#include "tests/core/fluid/conservative/basin.h"

namespace pentimento::conservative {
namespace {

constexpr int kWidth = 1024, kHeight = 768;

// Runny paint of uneven depth and stiffness everywhere, tilted: nothing can sleep.
Basin running_canvas(int threads) {
  Basin b({kWidth, kHeight, 1.0, 0.75}, 2, 4, threads);
  b.gravity_m_s2 = {2, -3, 9};
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      b.state.base_m(x, y) = 1e-4f * static_cast<float>((x * 7 + y * 5) % 4);
      const float d = 0.002f + 0.0004f * static_cast<float>((x / 8 + 2 * (y / 8)) % 5);
      b.state.depth_m(x, y) = d;
      for (int k = 0; k < 2; ++k)
        for (int c = 0; c < 4; ++c)
          b.state.channel(k, c)(x, y) = 0.25f * d * static_cast<float>(k + 1);
    }
  b.steps(5);
  return b;
}

void report(benchmark::State& state) {
  state.counters["ns_per_cell"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * kWidth * kHeight * 1e-9,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

// Gravity that walks round once in two seconds: the paint never comes to rest.
void turn(Basin& b, int step) {
  constexpr std::array<float, 8> kCircle = {0, 0.7071f, 1, 0.7071f, 0, -0.7071f, -1, -0.7071f};
  const auto at = static_cast<std::size_t>(step / 11);
  b.gravity_m_s2 = {4 * kCircle[at % 8], 4 * kCircle[(at + 2) % 8], 9};
}

// Processor time of each pass, of all threads together.
class PassClock {
 public:
  void begin() { since_ = std::clock(); }
  void passed(const char* name) {
    const std::clock_t now = std::clock();
    auto at = std::find_if(ns_.begin(), ns_.end(), [&](const auto& p) { return p.first == name; });
    if (at == ns_.end()) at = ns_.insert(at, {name, 0.0});
    at->second += 1e9 / CLOCKS_PER_SEC * static_cast<double>(now - since_);
    since_ = now;
  }
  void report(benchmark::State& state) const {
    const double cells = static_cast<double>(state.iterations()) * kWidth * kHeight;
    for (const auto& [name, ns] : ns_) state.counters["ns_" + name] = ns / cells;
  }

 private:
  std::vector<std::pair<std::string, double>> ns_;
  std::clock_t since_ = 0;
};

void ConservativeStep(benchmark::State& state) {
  Basin b = running_canvas(static_cast<int>(state.range(0)));
  PassClock clock;
  b.scheme.on_pass([&](const char* pass) { clock.passed(pass); });
  int step = 0;
  double awake = 1;
  for (auto _ : state) {
    turn(b, step++);
    clock.begin();
    b.step();
    awake = std::min(awake, b.scheme.awake_share());
  }
  state.counters["awake_min"] = awake;
  state.counters["speed"] = b.statistic("max_speed_m_s");
  clock.report(state);
  report(state);
}
/// The same with and without surface tension, and with films that end: bare stripes, 24 cells of
/// each 48. Arguments: whether films end, N/m in thousandths.
void ConservativeTension(benchmark::State& state) {
  Basin b = running_canvas(1);
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

BENCHMARK(ConservativeStep)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

void ConservativeMovePaint(benchmark::State& state) {
  Basin b = running_canvas(static_cast<int>(state.range(1)));
  const Axis axis = state.range(0) == 0 ? Axis::kX : Axis::kY;
  SleepTiles tiles(b.state.geometry, b.model.sleep_tile_m);
  b.state.sleep.clear();
  const StepInput in{b.model, b.gravity_m_s2, b.dt_s, b.contact, b.amount, b.pool};
  tiles.wake(b.state, in);
  for (auto _ : state) advect_paint(b.state, in, axis, tiles);
  report(state);
}
BENCHMARK(ConservativeMovePaint)
    ->ArgsProduct({{0, 1}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void ConservativeMoveMomentum(benchmark::State& state) {
  Basin b = running_canvas(static_cast<int>(state.range(1)));
  const Axis axis = state.range(0) == 0 ? Axis::kX : Axis::kY;
  SleepTiles tiles(b.state.geometry, b.model.sleep_tile_m);
  Workspace work(b.state.geometry);
  b.state.sleep.clear();
  const StepInput in{b.model, b.gravity_m_s2, b.dt_s, b.contact, b.amount, b.pool};
  tiles.wake(b.state, in);
  fill_node_masses(b.state, tiles, b.pool, work);
  for (auto _ : state) advect_momentum(b.state, in, axis, Turn::kFirst, tiles, work);
  report(state);
}
BENCHMARK(ConservativeMoveMomentum)
    ->ArgsProduct({{0, 1}, {1, 2}})
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
  for (auto _ : state) solver.solve(1, 6, threads, {});
  report(state);
}
BENCHMARK(ConservativeVCycle)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

void ConservativePaperStep(benchmark::State& state) {
  Basin b = running_canvas(static_cast<int>(state.range(0)));
  b.model.scheme = SchemeKind::kPaper;
  const auto scheme = make_scheme(SchemeKind::kPaper, b.state.geometry, 2, 4);
  const StepInput in{b.model, b.gravity_m_s2, b.dt_s, b.contact, b.amount, b.pool};
  for (auto _ : state) scheme->step(b.state, in);
  report(state);
}
BENCHMARK(ConservativePaperStep)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

// Reads and writes one plane in place: 8 bytes a cell.
void ConservativeMemoryProbe(benchmark::State& state) {
  std::vector<Field<float>> planes;
  for (int i = 0; i < 40; ++i) planes.emplace_back(kWidth, kHeight, 1.0f);  // far beyond the cache
  std::size_t k = 0;
  for (auto _ : state) {
    Field<float>& p = planes[k++ % planes.size()];
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) p(x, y) *= 1.0001f;
    benchmark::ClobberMemory();
  }
  report(state);
  state.SetBytesProcessed(state.iterations() * kWidth * kHeight * 8);
}
BENCHMARK(ConservativeMemoryProbe)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace pentimento::conservative
