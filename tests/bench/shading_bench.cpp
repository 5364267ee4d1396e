// Shading a painted canvas of two layers and four channels, ms per megapixel of picture. Mesa reads
// its number of threads once per process: run one number at a time with --benchmark_filter. CPU is
// that of all its threads.
#include <benchmark/benchmark.h>

#include "core/optics/paints/paint_maker.h"
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

void shade_canvas(benchmark::State& state, int picture_width, const Canvas& canvas,
                  const Lighting& light = {}, int slopes = 2) {
  auto shader = Shader::open(GlBackend::kAuto, static_cast<int>(state.range(0)));
  if (!shader) {
    state.SkipWithError(shader.error().message.c_str());
    return;
  }
  ShadeRequest request;
  request.width = picture_width;
  request.height = picture_width * 3 / 4;
  request.relief_samples = slopes;
  Drop drop;
  const auto picture = [&] {
    auto done = (*shader)->shade(StateSource(canvas.state), canvas.basis, canvas.model, light,
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

/// Arguments: Mesa's threads; slopes per cell and axis whose light is a cell's. 1024 x 768 cells
/// and pixels.
void shade_slopes(benchmark::State& state) {
  shade_canvas(state, 1024, painted_canvas(0, 1024), {}, static_cast<int>(state.range(1)));
}

/// Arguments: Mesa's threads; bands, 0 is RGB. 1024 x 768 cells and pixels.
void shade_bands(benchmark::State& state) {
  shade_canvas(state, 1024, painted_canvas(static_cast<int>(state.range(1)), 1024));
}

/// Features from which on a canvas has 15 bands, a probe, seven lamps.
constexpr int kSpectral = 5, kMany = 6, kEverything = 7;

/// The light of shade_feature's argument.
Lighting lighting_of(int features) {
  Lighting light;
  if (features == 0) light.lamps[0].intensity = 0;
  light.occlusion = features >= 2 ? 1 : 0;
  if (features >= 3) {
    for (Field<float>& plane : light.reflection.rgb) plane = Field<float>(640, 360, 0.4f);
    light.varnish = 0.5f;
    light.white_xy = {0.38f, 0.38f};
  }
  if (features == kEverything) {
    for (Field<float>& plane : light.probe) plane = Field<float>(512, 256, 0.5f);
  }
  const int lamps = features < 4 ? 1 : features < kMany ? 3 : kMostLamps;
  for (int i = 1; i < lamps; ++i) {
    Lamp lamp;
    if (i % 2 == 1) lamp.position_m = {0.03f * static_cast<float>(i), 0.1f, 0.3f};
    light.lamps.push_back(lamp);
  }
  return light;
}

/// What each part of the light costs, cell by cell at 1024 x 768. Arguments: Mesa's threads; 0
/// nothing but the room, 1 and one lamp, 2 and occlusion and shadows with it, 3 and the camera's
/// picture, varnish and white balance, 4 and two more lamps, one of them near, 5 and 15 bands, 6
/// seven lamps in RGB, 7 seven lamps, 15 bands and a light probe, whose table is made beforehand.
void shade_feature(benchmark::State& state) {
  const int features = static_cast<int>(state.range(1));
  const bool spectral = features == kSpectral || features == kEverything;
  shade_canvas(state, 1024, painted_canvas(spectral ? 15 : 0, 1024), lighting_of(features));
}

BENCHMARK(shade_feature)
    ->ArgNames({"gl_threads", "features"})
    ->ArgsProduct({{1, 2}, {0, 1, 2, 3, 4, 5, 6, 7}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

BENCHMARK(shade)
    ->ArgNames({"gl_threads", "picture", "grid"})
    ->ArgsProduct({{0, 1, 2}, {1024, 2048}, {1024, 2048}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

BENCHMARK(shade_slopes)
    ->ArgNames({"gl_threads", "slopes"})
    ->ArgsProduct({{1, 2}, {1, 2}})
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
