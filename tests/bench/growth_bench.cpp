// How the cost of a step grows: with the awake part of the canvas, its size, and threads, in both
// fluids. The detail is in detail_bench.cpp.
//   build/pentimento_bench --benchmark_filter='^Growth'
// An item is a cell of the canvas, wet or not.

#include <benchmark/benchmark.h>

#include "core/simulation/make_scheme.h"
#include "tests/bench/least_time.h"
#include "tests/bench/running_canvas.h"

namespace pentimento::conservative {
namespace {

/// Arguments: cells across the canvas (4:3), cells across its wet corner, threads.
void GrowthConservative(benchmark::State& run) {
  const int width = static_cast<int>(run.range(0)), wet = static_cast<int>(run.range(1));
  Basin b = running_canvas(width, wet, static_cast<int>(run.range(2)));
  int step = 0;
  double awake = 0;
  LeastTime least;
  for (auto _ : run) {
    turn(b, step++);
    least.time([&] { b.step(); });
    awake += b.scheme.awake_share();
  }
  if (run.range(2) == 1) least.report(run, 0.75 * width * width);
  run.counters["awake_share"] = awake / step;
  run.SetItemsProcessed(run.iterations() * width * width * 3 / 4);
}

/// The same arguments.
void GrowthPaper(benchmark::State& run) {
  const int width = static_cast<int>(run.range(0)), wet = static_cast<int>(run.range(1));
  Basin b = running_canvas(width, wet, static_cast<int>(run.range(2)));
  b.model.scheme = SchemeKind::kPaper;
  const auto scheme = make_scheme(SchemeKind::kPaper, b.state.geometry, 2, 4);
  int step = 0;
  LeastTime least;
  for (auto _ : run) {
    turn(b, step++);
    const StepInput in{b.model, b.gravity_m_s2, b.dt_s, b.contact, b.amount, b.pool};
    least.time([&] { scheme->step(b.state, in); });
  }
  if (run.range(2) == 1) least.report(run, 0.75 * width * width);
  run.SetItemsProcessed(run.iterations() * width * width * 3 / 4);
}

void sizes(benchmark::internal::Benchmark* b) {
  for (const int wet : {0, 128, 256, 512, 1024}) b->Args({1024, wet, 1});
  for (const int width : {256, 512, 2048}) b->Args({width, width, 1});
  b->Args({1024, 1024, 2})->Args({2048, 2048, 2});
  b->Iterations(4)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
}
BENCHMARK(GrowthConservative)->Apply(sizes);
BENCHMARK(GrowthPaper)->Apply(sizes);

}  // namespace
}  // namespace pentimento::conservative
