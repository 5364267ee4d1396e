// Shading a painted canvas of two layers and four channels, ms per megapixel of picture. Mesa reads
// its number of threads once per process: run one number at a time with --benchmark_filter. CPU is
// that of all its threads.
#include <benchmark/benchmark.h>

#include "core/optics/paint_maker.h"
#include "core/shading/shader.h"
#include "tests/reference/painted_scene.h"

namespace pentimento {
namespace {

class Drop : public PictureSink {
 public:
  Result<void> write(const PictureStrip&) override { return {}; }
};

struct Canvas {
  Model model;
  ChannelBasis basis;
  CanvasState state;
};

/// 0 bands: RGB. The dry layer of a spectral canvas is grey where it has more bands than three.
Canvas painted_canvas(int bands, int grid) {
  Canvas out;
  std::vector<Pigment> palette = painted::palette();
  if (bands > 0) {
    out.model.optics = OpticsKind::kSpectral;
    out.model.bands = bands;
    out.model.saunderson_k2 = static_cast<float>(kMeasuredK2);
    const PaintMaker maker(out.model);
    for (Pigment& pigment : palette) pigment = *maker.from_library(pigment.name);
    out.basis = make_channels(palette, maker.wavelength_nm());
  } else {
    out.basis = palette_channels(palette);
  }
  out.state = painted::scene(out.basis, grid, grid * 3 / 4);
  for (; out.state.bands < bands; ++out.state.bands)
    out.state.reflectance.push_back(out.state.reflectance.front().clone());
  return out;
}

void shade_canvas(benchmark::State& state, int picture_width, const Canvas& canvas) {
  auto shader = Shader::open(GlBackend::kAuto, static_cast<int>(state.range(0)));
  if (!shader) {
    state.SkipWithError(shader.error().message.c_str());
    return;
  }
  ShadeRequest request;
  request.width = picture_width;
  request.height = picture_width * 3 / 4;
  Drop drop;
  const auto picture = [&] {
    auto done = (*shader)->shade(StateSource(canvas.state), canvas.basis, canvas.model, Lighting{},
                                 request, {&drop});
    if (!done) state.SkipWithError(done.error().message.c_str());
  };
  picture();  // compiles the program, once per context
  for (auto _ : state) picture();
  const double megapixels = 1e-6 * request.width * request.height;
  state.counters["s_per_Mpx"] =
      benchmark::Counter(megapixels * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// Arguments: Mesa's threads; picture's width; grid's width. 4:3.
void shade(benchmark::State& state) {
  shade_canvas(state, static_cast<int>(state.range(1)),
               painted_canvas(0, static_cast<int>(state.range(2))));
}

/// Arguments: Mesa's threads; bands, 0 is RGB. 1024 x 768 cells and pixels.
void shade_bands(benchmark::State& state) {
  shade_canvas(state, 1024, painted_canvas(static_cast<int>(state.range(1)), 1024));
}

BENCHMARK(shade)
    ->ArgNames({"gl_threads", "picture", "grid"})
    ->ArgsProduct({{0, 1, 2}, {1024, 2048}, {1024, 2048}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

BENCHMARK(shade_bands)
    ->ArgNames({"gl_threads", "bands"})
    ->ArgsProduct({{0, 1, 2}, {0, 8, 12, 15, 38}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace pentimento
