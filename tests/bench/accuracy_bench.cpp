// Errors of both fluid schemes against exact solutions: the table of docs/numerics.md.
//   build/pentimento_bench --benchmark_filter=Accuracy --benchmark_counters_tabular=true

#include <benchmark/benchmark.h>

#include "tests/core/fluid/analytic_case.h"

namespace pentimento {
namespace {

AnalyticCase case_of(std::int64_t index) {
  if (index < 2) return dam_break_case(index == 0 ? 0.001 : 0.0);
  return thacker_case(index == 2);
}

// Arguments: case (0 Stoker, 1 Ritter, 2 Thacker planar, 3 Thacker radial), scheme (0 paper,
// 1 conservative), cells along x, 100 x c dt/dx.
void Accuracy(benchmark::State& state) {
  const AnalyticCase c = case_of(state.range(0));
  const auto kind = state.range(1) == 0 ? SchemeKind::kPaper : SchemeKind::kConservative;
  const int base = state.range(0) < 2 ? 100 : 40;
  const int cells = base << state.range(2);
  double error = 0;
  for (auto _ : state)
    error = relative_l1(c, kind, cells, static_cast<double>(state.range(3)) / 100);
  state.counters["cells"] = cells;
  state.counters["L1_percent"] = 100 * error;
}
BENCHMARK(Accuracy)
    ->ArgsProduct({{0, 1, 2, 3}, {0, 1}, {0, 1, 2}, {50, 100, 200}})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pentimento
