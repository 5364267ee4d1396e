// What the machine gives: bytes a second from its caches and its memory, and operations a second.
// The phases of the other benchmarks are measured against these, in the same run.
//   build/pentimento_bench --benchmark_filter='^Probe'
// An item of the first four is a float of one plane; of the last two, an operation. They are
// compiled as kernels are, for the same instruction set. One thread.

#include <benchmark/benchmark.h>

#include <array>
#include <bit>
#include <cstdint>

#include "core/base/field.h"
#include "core/base/kernel.h"
#include "tests/bench/least_time.h"
#include "tests/golden/instruction_set.h"

namespace pentimento {
namespace {

// Floats of a plane: one to three planes are 64 to 192 KiB, which the second cache of a core holds
// and the first does not; or 96 to 288 MiB, more than a core's share of any last cache.
constexpr int kNear = 16 * 1024, kFar = 24 * 1024 * 1024;
constexpr int kPassesTogether = 50;  // over near planes: what the clock takes is little beside them

PENTIMENTO_KERNEL
std::int32_t read_row(const float* a, int n) {
  std::int32_t any = 0;
  for (int i = 0; i < n; ++i) any |= std::bit_cast<std::int32_t>(a[i]);
  return any;
}

PENTIMENTO_KERNEL
void update_row(float* a, int n) {
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) a[i] *= 1.0000001f;
}

PENTIMENTO_KERNEL
void copy_row(const float* __restrict a, int n, float* __restrict out) {
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) out[i] = 0.5f * a[i];
}

PENTIMENTO_KERNEL
void triad_row(const float* __restrict a, const float* __restrict b, int n, float* __restrict out) {
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) out[i] = a[i] + 0.5f * b[i];
}

// Planes whose pages are all there, for something is written to each.
struct Planes {
  Planes(int n, int planes)
      : size(n), a(n, 1, 1.0f), b(planes > 2 ? n : 0, 1, 2.0f), out(planes > 1 ? n : 0, 1, 3.0f) {}
  int size;
  Field<float> a, b, out;
};

/// `size`: floats of a plane; `planes`: how many take part; `bytes`: of a float and pass.
template <typename Pass>
void probe(benchmark::State& run, int size, int planes, int bytes, const Pass& pass) {
  Planes p(size, planes);
  const int passes = size == kNear ? kPassesTogether : 1;
  LeastTime least;
  for (auto _ : run)
    least.time([&] {
      for (int i = 0; i < passes; ++i) {
        pass(p);
        benchmark::ClobberMemory();
      }
    });
  least.report(run, static_cast<double>(size) * passes);
  run.SetItemsProcessed(run.iterations() * passes * size);
  run.SetBytesProcessed(run.iterations() * passes * size * bytes);
}

void read(benchmark::State& run, int size) {
  probe(run, size, 1, 4, [](Planes& p) { benchmark::DoNotOptimize(read_row(p.a.row(0), p.size)); });
}
void update(benchmark::State& run, int size) {
  probe(run, size, 1, 8, [](Planes& p) { update_row(p.a.row(0), p.size); });
}
void copy(benchmark::State& run, int size) {
  probe(run, size, 2, 8, [](Planes& p) { copy_row(p.a.row(0), p.size, p.out.row(0)); });
}
void triad(benchmark::State& run, int size) {
  probe(run, size, 3, 12,
        [](Planes& p) { triad_row(p.a.row(0), p.b.row(0), p.size, p.out.row(0)); });
}

// Sixteen vectors that stay in registers, each its own chain of operations.
constexpr int kRounds = 1000, kLanes = 16, kChains = 16;
typedef float Vector __attribute__((vector_size(kLanes * sizeof(float))));
using Chains = std::array<Vector, kChains>;

PENTIMENTO_KERNEL
void add_multiply(Chains& values, float by, float plus) {
  Chains x = values;
  for (int round = 0; round < kRounds; ++round)
#pragma GCC unroll 16
    for (Vector& v : x) v = v * by + plus;
  values = x;
}

PENTIMENTO_KERNEL
void divide(Chains& values, float by) {
  Chains x = values;
  for (int round = 0; round < kRounds; ++round)
#pragma GCC unroll 16
    for (Vector& v : x) v = by / v;
  values = x;
}

template <typename Pass>
void arithmetic(benchmark::State& run, int operations, const Pass& pass) {
  Chains x;
  for (Vector& v : x) v = Vector{} + 1.5f;
  LeastTime least;
  for (auto _ : run)
    least.time([&] {
      pass(x);
      benchmark::DoNotOptimize(x);
    });
  least.report(run, kRounds * kChains * kLanes * operations);
  run.SetItemsProcessed(run.iterations() * kRounds * kChains * kLanes * operations);
  run.SetLabel(instruction_set());
}

void add_and_multiply(benchmark::State& run) {
  arithmetic(run, 2, [](Chains& x) { add_multiply(x, 0.999f, 0.001f); });
}
void divisions(benchmark::State& run) {
  arithmetic(run, 1, [](Chains& x) { divide(x, 1.25f); });
}

// Long enough to be told from noise, short enough to be repeated often.
constexpr int kNearPasses = 200, kFarPasses = 4, kRuns = 1000;
BENCHMARK_CAPTURE(read, l2, kNear)->Name("Probe/read/L2")->Iterations(kNearPasses);
BENCHMARK_CAPTURE(update, l2, kNear)->Name("Probe/update/L2")->Iterations(kNearPasses);
BENCHMARK_CAPTURE(copy, l2, kNear)->Name("Probe/copy/L2")->Iterations(kNearPasses);
BENCHMARK_CAPTURE(triad, l2, kNear)->Name("Probe/triad/L2")->Iterations(kNearPasses);
BENCHMARK_CAPTURE(read, dram, kFar)->Name("Probe/read/DRAM")->Iterations(kFarPasses);
BENCHMARK_CAPTURE(update, dram, kFar)->Name("Probe/update/DRAM")->Iterations(kFarPasses);
BENCHMARK_CAPTURE(copy, dram, kFar)->Name("Probe/copy/DRAM")->Iterations(kFarPasses);
BENCHMARK_CAPTURE(triad, dram, kFar)->Name("Probe/triad/DRAM")->Iterations(kFarPasses);
BENCHMARK(add_and_multiply)->Name("Probe/add_multiply")->Iterations(kRuns);
BENCHMARK(divisions)->Name("Probe/divide")->Iterations(kRuns);

}  // namespace
}  // namespace pentimento
