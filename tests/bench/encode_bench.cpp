// Encoding and publishing (fsync and reading back included) of a 2048 x 1536 picture and of the
// state of a canvas of that size. Rates are of the bytes before compression.

#include <benchmark/benchmark.h>

#include <filesystem>
#include <random>

#include "core/optics/channels.h"
#include "formats/exr/exr_writer.h"
#include "formats/hdf5/state_dump.h"
#include "formats/image/resample.h"
#include "formats/png/png_writer.h"

namespace pentimento {
namespace {

constexpr int kWidth = 2048, kHeight = 1536, kStripRows = 256;

std::string scratch_file(const char* name) {
  return (std::filesystem::temp_directory_path() / name).string();
}

/// Soft patches with fine grain, as paint on canvas has them.
Field<float> painting(unsigned seed) {
  std::mt19937 random(seed);
  Field<float> coarse(24, 18);
  for (int y = 0; y < 18; ++y)
    for (int x = 0; x < 24; ++x) coarse(x, y) = static_cast<float>(random() % 1000) / 1000.0f;
  Field<float> plane = resample_bicubic(coarse.view(), kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      plane(x, y) += 0.02f * (static_cast<float>(random() % 1000) / 1000.0f - 0.5f);
  return plane;
}

const std::vector<Field<float>>& picture() {
  static const std::vector<Field<float>> planes = [] {
    std::vector<Field<float>> made;
    for (unsigned c = 0; c < 3; ++c) made.push_back(painting(c));
    return made;
  }();
  return planes;
}

bool write_strips(PictureFile& file) {
  for (int y = 0; y < kHeight; y += kStripRows) {
    PictureStrip strip;
    strip.y0 = y;
    strip.rows = kStripRows;
    strip.name = {"R", "G", "B"};
    for (const Field<float>& plane : picture())
      strip.plane.push_back(plane.view().window(0, y, kWidth, kStripRows));
    if (!file.write(strip)) return false;
  }
  return file.finish().ok();
}

void report(benchmark::State& state, double bytes, const std::string& path) {
  state.counters["MB/s"] =
      benchmark::Counter(bytes * 1e-6, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["file_MB"] = static_cast<double>(std::filesystem::file_size(path)) * 1e-6;
  std::filesystem::remove(path);
}

void encode_png(benchmark::State& state) {
  const std::string path = scratch_file("pentimento_bench.png");
  PngOptions options;
  options.width = kWidth;
  options.height = kHeight;
  options.bit_depth = static_cast<int>(state.range(0));
  options.threads = static_cast<int>(state.range(1));
  picture();
  for (auto _ : state) {
    auto file = create_png(path, options);
    if (!file || !write_strips(**file)) state.SkipWithError("cannot write");
  }
  report(state, 3.0 * kWidth * kHeight * options.bit_depth / 8, path);
}
BENCHMARK(encode_png)
    ->ArgNames({"bits", "threads"})
    ->ArgsProduct({{8, 16}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void encode_exr(benchmark::State& state) {
  const std::string path = scratch_file("pentimento_bench.exr");
  ExrOptions options;
  options.width = kWidth;
  options.height = kHeight;
  options.channels = {"R", "G", "B"};
  options.full_float = state.range(0) == 32;
  options.threads = static_cast<int>(state.range(1));
  picture();
  for (auto _ : state) {
    auto file = create_exr(path, options);
    if (!file || !write_strips(**file)) state.SkipWithError("cannot write");
  }
  report(state, 3.0 * kWidth * kHeight * static_cast<double>(state.range(0)) / 8, path);
}
BENCHMARK(encode_exr)
    ->ArgNames({"bits", "threads"})
    ->ArgsProduct({{16, 32}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// Two layers of three pigments, every plane full of paint: the worst case.
StateDump full_canvas() {
  StateDump dump;
  for (const char* name : {"a", "b", "c"})
    dump.palette.push_back({name, Eigen::Vector3d(0.1, 0.2, 0.3), Eigen::Vector3d(0.3, 0.2, 0.1)});
  dump.basis = palette_channels(dump.palette);
  dump.state = make_canvas_state({kWidth, kHeight, 1, 0.75}, 2, 3, 3, 0.9f);
  unsigned seed = 10;
  CanvasState& s = dump.state;
  for (Field<float>* plane : {&s.depth_m, &s.velocity_x_m_s, &s.velocity_y_m_s, &s.base_m})
    *plane = painting(seed++);
  const Field<float> paper_m = painting(seed++);
  for (int y = 0; y < kHeight; ++y) write_paper(s, 0, y, paper_m.view().row_span(y));
  for (GroundPlane& plane : s.reflectance) {
    const Field<float> band = painting(seed++);
    for (int y = 0; y < kHeight; ++y) plane.write(0, y, band.view().row_span(y));
  }
  for (Field<float>& plane : s.pigment) plane = painting(seed++);
  return dump;
}

void write_dump(benchmark::State& state) {
  const std::string path = scratch_file("pentimento_bench.h5");
  static const StateDump dump = full_canvas();
  DumpOptions options;
  options.threads = static_cast<int>(state.range(0));
  for (auto _ : state)
    if (!write_state(path, dump, options)) state.SkipWithError("cannot write");
  const double planes = 16;  // 8 of the canvas, 6 of pigment, strokes, height
  report(state, planes * 4 * kWidth * kHeight, path);
}
BENCHMARK(write_dump)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void hash_state(benchmark::State& state) {
  static const StateDump dump = full_canvas();
  for (auto _ : state) benchmark::DoNotOptimize(state_sha256(dump.state));
  state.counters["MB/s"] = benchmark::Counter(15.0 * 4 * kWidth * kHeight * 1e-6,
                                              benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(hash_state)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
}  // namespace pentimento
