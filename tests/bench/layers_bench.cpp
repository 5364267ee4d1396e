// What a stamp does to the layers of a row of cells: picking up, mixing, depositing; 2 layers of 4
// channels, which the first caches hold. An item is a cell.
//   build/pentimento_bench --benchmark_filter='^Layers'

#include <benchmark/benchmark.h>

#include <algorithm>
#include <vector>

#include "core/layers/deposit.h"
#include "core/layers/mix_layers.h"
#include "core/layers/pick_up.h"
#include "tests/bench/least_time.h"
#include "tests/core/layers/layer_cells.h"

namespace pentimento {
namespace {

constexpr int kCells = 512, kLayers = 2, kChannels = 4;
constexpr int kStride = 8;         // as a reservoir has it: a multiple of four
constexpr int kRowsTogether = 20;  // what the clock takes is little beside them
constexpr int kRepeats = 100;      // enough to be told from noise, quick to be repeated
// So little that the cells hold what they held after all repeats, and no number becomes denormal.
constexpr float kLittle = 1e-7f;

struct Row {
  Row() {
    for (Field<float>& plane : cells.state().pigment)
      for (int x = 0; x < kCells; ++x) plane(x, 0) = 0.01f + 1e-5f * static_cast<float>(x % 97);
  }
  LayerCells cells{kLayers, kChannels, kCells};
  std::vector<float> weight = std::vector<float>(kCells, 0.7f);
  std::vector<float> depth_m = std::vector<float>(kCells, 0.001f);
  std::vector<float> paint = std::vector<float>(kCells * kStride);
  std::vector<double> sums = std::vector<double>(1 + kChannels);
  std::vector<std::uint32_t> stroke = std::vector<std::uint32_t>(kCells, 1);
};

template <typename Pass>
void layers(benchmark::State& run, const Pass& pass) {
  Row row;
  const LayerRow cells = row.cells.row();
  LeastTime least;
  for (auto _ : run)
    least.time([&] {
      for (int i = 0; i < kRowsTogether; ++i) {
        pass(row, cells);
        benchmark::ClobberMemory();
      }
    });
  least.report(run, kCells * kRowsTogether);
  run.SetItemsProcessed(run.iterations() * kCells * kRowsTogether);
}

void LayersPickUp(benchmark::State& run) {
  layers(run, [](Row& r, const LayerRow& cells) {
    pick_up_row({kLittle, 0.5f, 0.001f}, cells, r.weight, r.depth_m.data(), r.paint.data(), kStride,
                r.sums);
  });
}
void LayersMix(benchmark::State& run) {
  layers(run, [](Row& r, const LayerRow& cells) {
    mix_layers_row({0.1f, 0.001f}, cells, r.weight);
  });
}
void LayersDeposit(benchmark::State& run) {
  layers(run, [](Row& r, const LayerRow& cells) {
    std::fill(r.paint.begin(), r.paint.end(), kLittle);
    deposit_row({1, 1}, cells, r.depth_m, r.stroke.data(), r.paint.data(), kStride, r.sums);
  });
}
BENCHMARK(LayersPickUp)->Iterations(kRepeats);
BENCHMARK(LayersMix)->Iterations(kRepeats);
BENCHMARK(LayersDeposit)->Iterations(kRepeats);

}  // namespace
}  // namespace pentimento
