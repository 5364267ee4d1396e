// Shading a painted canvas of two layers and four channels, ms per megapixel of picture. Mesa reads
// its number of threads once per process: run one number at a time with --benchmark_filter. CPU is
// that of all its threads.
#include <benchmark/benchmark.h>

#include "core/shading/shader.h"
#include "tests/reference/painted_scene.h"

namespace pentimento {
namespace {

class Drop : public PictureSink {
 public:
  Result<void> write(const PictureStrip&) override { return {}; }
};

/// Arguments: Mesa's threads; picture's width; grid's width. 4:3.
void shade(benchmark::State& state) {
  auto shader = Shader::open(GlBackend::kAuto, static_cast<int>(state.range(0)));
  if (!shader) {
    state.SkipWithError(shader.error().message.c_str());
    return;
  }
  ShadeRequest request;
  request.width = static_cast<int>(state.range(1));
  request.height = request.width * 3 / 4;
  const int grid = static_cast<int>(state.range(2));
  const ChannelBasis basis = palette_channels(painted::palette());
  const CanvasState canvas = painted::scene(basis, grid, grid * 3 / 4);
  Drop drop;
  const auto picture = [&] {
    auto done = (*shader)->shade(StateSource(canvas), basis, Model{}, Lighting{}, request, {&drop});
    if (!done) state.SkipWithError(done.error().message.c_str());
  };
  picture();  // compiles the program, once per context
  for (auto _ : state) picture();
  const double megapixels = 1e-6 * request.width * request.height;
  state.counters["s_per_Mpx"] =
      benchmark::Counter(megapixels * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

BENCHMARK(shade)
    ->ArgNames({"gl_threads", "picture", "grid"})
    ->ArgsProduct({{0, 1, 2}, {1024, 2048}, {1024, 2048}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace pentimento
