// A poster from a canvas that is nowhere held: shading, encoding and publishing a made-up canvas of
// two layers and four channels, 4:3. CPU is that of all threads; peak_MB is the process's.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <filesystem>

#include "core/shading/guided_picture.h"
#include "core/shading/shader.h"
#include "formats/exr/exr_writer.h"
#include "formats/png/png_writer.h"
#include "tests/reference/made_up_canvas.h"
#include "tests/reference/painted_scene.h"

namespace pentimento {
namespace {

enum Output { kNothing, kPng, kExr };

class Drop : public PictureSink {
 public:
  Result<void> write(const PictureStrip&) override { return {}; }
};

std::unique_ptr<PictureFile> open_output(int output, const std::string& path, int width,
                                         int height) {
  if (output == kPng) {
    PngOptions options;
    options.width = width;
    options.height = height;
    options.threads = 2;
    auto file = create_png(path, options);
    return file ? std::move(*file) : nullptr;
  }
  ExrOptions options;
  options.width = width;
  options.height = height;
  options.channels = {"R", "G", "B"};
  options.threads = 2;
  auto file = create_exr(path, options);
  return file ? std::move(*file) : nullptr;
}

/// Arguments: the picture's width, which is the canvas's; what is written.
void poster(benchmark::State& state) {
  auto shader = Shader::open(GlBackend::kAuto, 2);
  if (!shader) return state.SkipWithError(shader.error().message.c_str());
  ShadeRequest request;
  request.width = static_cast<int>(state.range(0));
  request.height = request.width * 3 / 4;
  const int output = static_cast<int>(state.range(1));
  const ChannelBasis basis = palette_channels(painted::palette());
  const reference::MadeUpCanvas canvas({request.width, request.height, 0.4, 0.3}, 2,
                                       basis.channels());
  const std::string path =
      (std::filesystem::temp_directory_path() / "pentimento_poster_bench").string();
  for (auto _ : state) {
    Drop drop;
    auto file =
        output == kNothing ? nullptr : open_output(output, path, request.width, request.height);
    PictureSink* sink = file ? static_cast<PictureSink*>(file.get()) : &drop;
    const auto done = (*shader)->shade(canvas, basis, Model{}, Lighting{}, request, {sink});
    if (!done || (file && !file->finish())) state.SkipWithError("cannot write");
  }
  const double megapixels = 1e-6 * request.width * request.height;
  struct rusage usage {};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["s_per_Mpx"] =
      benchmark::Counter(megapixels * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["peak_MB"] = static_cast<double>(usage.ru_maxrss) * 1.024e-3;
  if (output != kNothing) {
    state.counters["file_MB"] = 1e-6 * static_cast<double>(std::filesystem::file_size(path));
    std::filesystem::remove(path);
  }
}

/// What it costs that the light is the guide's: nothing is written. Arguments: the picture's width,
/// which is the canvas's; cells and pixels on a cell of the guide, 0: no guide.
void poster_light(benchmark::State& state) {
  auto shader = Shader::open(GlBackend::kAuto, 2);
  if (!shader) return state.SkipWithError(shader.error().message.c_str());
  ShadeRequest request;
  request.width = static_cast<int>(state.range(0));
  request.height = request.width * 3 / 4;
  request.relief_samples = 1;  // as under a guide
  request.edges = EdgeCells::kCovered;
  const int detail = static_cast<int>(state.range(1)), coarser = std::max(detail, 1);
  const ChannelBasis basis = palette_channels(painted::palette());
  const CanvasGeometry fine{request.width, request.height, 0.4, 0.3};
  const reference::MadeUpCanvas canvas(fine, 2, basis.channels());
  const reference::MadeUpCanvas guide({fine.width / coarser, fine.height / coarser, 0.4, 0.3}, 2,
                                      basis.channels());
  const Threads threads(2);
  Drop drop;
  const auto picture = [&] {
    const auto done = detail == 0
                          ? (*shader)->shade(canvas, basis, Model{}, Lighting{}, request, {&drop})
                          : shade_guided(**shader, {guide, canvas}, basis, Model{}, Lighting{},
                                         request, threads, {&drop});
    if (!done) state.SkipWithError(done.error().message.c_str());
  };
  picture();  // compiles the programs, once per context
  for (auto _ : state) picture();
  const double megapixels = 1e-6 * request.width * request.height;
  state.counters["s_per_Mpx"] =
      benchmark::Counter(megapixels * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

BENCHMARK(poster_light)
    ->ArgNames({"width", "detail"})
    ->ArgsProduct({{4096}, {0, 2, 4, 8}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

BENCHMARK(poster)
    ->ArgNames({"width", "output"})
    ->ArgsProduct({{2048, 4096, 16384}, {kNothing, kPng, kExr}})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace pentimento
