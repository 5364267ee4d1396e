// Stamps per second: one stamp of the brush over wet paint. items = covered cells x planes (layers
// times height and channels), so that ns per cell and plane is 1e9 / items_per_second.

#include <benchmark/benchmark.h>

#include "core/brush/builtin_brushes.h"
#include "core/brush/stroke_path.h"
#include "core/optics/paints/pigment_library.h"
#include "core/simulation/simulation.h"
#include "tests/bench/least_time.h"

namespace pentimento {
namespace {

constexpr int kStampsTogether = 10;  // no stamp is like the next: the least of single ones is luck

SimulationSetup canvas(int layers) {
  SimulationSetup setup;
  setup.geometry = {512, 384, 0.512, 0.384};
  setup.model.layers = layers;
  std::vector<Pigment> palette;
  for (const char* name : {"Ultramarine Blue", "Vermilion", "Titanium White", "Yellow Ochre"})
    palette.push_back(*find_library_pigment(name));
  setup.basis = palette_channels(palette);
  return setup;
}

/// range(0): diameter in cells; range(1): layers.
void stamps(benchmark::State& bench, const char* brush) {
  const Threads threads(1);
  const int layers = static_cast<int>(bench.range(1));
  const float diameter_m = static_cast<float>(bench.range(0)) * 1e-3f;
  Simulation sim(canvas(layers), threads);
  sim.set_brush(*builtin_brush(brush));
  std::uint32_t id = 1;
  std::int64_t laid = 0;
  std::vector<Stamp> out;
  for (int i = 0; i < 2; ++i) {  // the first stroke wets the canvas, the second is measured
    StrokePath path(0.025, 0.512, 0.384);
    TouchSample sample;
    sample.diameter_m = diameter_m;
    sample.x_m = 0.1;
    sample.y_m = 0.19;
    path.begin(sample);
    sample.x_m = 0.4;
    sample.y_m = 0.21;
    sample.time_s = 1;
    out.clear();
    path.add(sample, out);
    path.finish(out);
    if (i == 0) {
      sim.begin_stroke(0, id++);
      for (const Stamp& s : out) sim.stamp(0, s);
      sim.end_stroke(0);
    }
  }
  sim.begin_stroke(0, id);
  LeastTime least;
  for (auto _ : bench)
    least.time([&] {
      for (int i = 0; i < kStampsTogether; ++i, ++laid)
        sim.stamp(0, out[static_cast<std::size_t>(laid) % out.size()]);
    });
  const double covered = 0.785 * static_cast<double>(bench.range(0) * bench.range(0));
  least.report(bench, covered * layers * 5 * kStampsTogether);
  bench.SetItemsProcessed(static_cast<std::int64_t>(static_cast<double>(laid) * covered) * layers *
                          5);
}

BENCHMARK_CAPTURE(stamps, round, "round")->ArgsProduct({{25, 60, 120}, {1, 2, 4}});
BENCHMARK_CAPTURE(stamps, bristle, "bristle")->Args({60, 2});
BENCHMARK_CAPTURE(stamps, flat, "flat")->Args({60, 2});

}  // namespace
}  // namespace pentimento
