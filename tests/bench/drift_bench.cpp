// How far the paint account drifts in a long session of the conservative scheme.
//   build/pentimento_bench --benchmark_filter=Drift
// Argument: strokes of 67 steps; 806 are 54,000 steps, 20 minutes.

#include <benchmark/benchmark.h>

#include "tests/core/fluid/conservative/painting_session.h"

namespace pentimento::conservative {
namespace {

void Drift(benchmark::State& state) {
  const Threads threads(0);
  PaintingSession session(256, threads);
  for (auto _ : state)
    for (int k = 0; k < state.range(0); ++k) session.stroke();
  const std::vector<double> drifts = session.drifts();
  state.counters["steps"] = session.steps();
  state.counters["medium"] = drifts[0];
  for (std::size_t c = 1; c < drifts.size(); ++c)
    state.counters["channel" + std::to_string(c - 1)] = drifts[c];
  for (const auto& [name, value] : session.simulation().statistics()) state.counters[name] = value;
}
BENCHMARK(Drift)->Arg(40)->Arg(806)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
}  // namespace pentimento::conservative
