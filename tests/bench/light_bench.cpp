// The horizon search and the light lock beside their plain twins (tests/reference). The twins work
// in double precision, cell by cell. One thread; an item is a cell, or a pixel of one colour.
//   build/pentimento_bench --benchmark_filter='^Light'

#include <benchmark/benchmark.h>

#include <vector>

#include "core/shading/horizon_row.h"
#include "core/shading/light_lock.h"
#include "tests/bench/least_time.h"
#include "tests/core/canvas/set_base.h"
#include "tests/reference/horizon.h"
#include "tests/reference/light_lock.h"
#include "tests/reference/made_up_canvas.h"

namespace pentimento {
namespace {

using reference::MadeUpCanvas;

constexpr int kCellsX = 128, kCellsY = 96, kPixels = 4;  // a cell has 4 x 4 pixels

/// Strokes with bristle marks on paper, cells of half a millimetre.
CanvasState relief() {
  CanvasState state =
      make_canvas_state({kCellsX, kCellsY, 5e-4 * kCellsX, 5e-4 * kCellsY}, 1, 1, 3, 0.9f);
  for (int y = 0; y < kCellsY; ++y)
    for (int x = 0; x < kCellsX; ++x)
      set_base(state, x, y, 1e-3f * MadeUpCanvas::unit(x / 4, y, 1));
  return state;
}

void report_cells(benchmark::State& run, const LeastTime& least) {
  least.report(run, kCellsX * kCellsY);
  run.SetItemsProcessed(run.iterations() * kCellsX * kCellsY);
}

void LightSky(benchmark::State& run) {
  const CanvasState state = relief();
  const int border = horizon_border(state.geometry);
  Field<float> height(kCellsX + 2 * border, kCellsY + 2 * border);
  for (int y = 0; y < height.height(); ++y)
    for (int x = 0; x < height.width(); ++x)
      height(x, y) = state.base_m(std::clamp(x - border, 0, kCellsX - 1),
                                  std::clamp(y - border, 0, kCellsY - 1));
  const HorizonLines lines = horizon_lines(state.geometry);
  const std::ptrdiff_t stride = height.view().stride();
  std::vector<float> seen(kCellsX);
  LeastTime least;
  for (auto _ : run)
    least.time([&] {
      for (int y = 0; y < kCellsY; ++y) {
        sky_seen_row(
            {height.row(y + border) + border, stride, state.geometry.dx_m(), state.geometry.dy_m()},
            lines, seen);
        benchmark::DoNotOptimize(seen.data());
        benchmark::ClobberMemory();
      }
    });
  report_cells(run, least);
}

void LightSkyPlainly(benchmark::State& run) {
  const CanvasState state = relief();
  Lighting lighting;
  lighting.occlusion = 1;
  const reference::HorizonReference twin(state, lighting);
  LeastTime least;
  for (auto _ : run)
    least.time([&] {
      for (int y = 0; y < kCellsY; ++y)
        for (int x = 0; x < kCellsX; ++x) benchmark::DoNotOptimize(twin.sky_seen(x, y));
    });
  report_cells(run, least);
}

/// Grain on an even ground, and the light that the guide's cells want.
float shown_at(int colour, int x, int y) {
  return 0.3f + 0.4f * MadeUpCanvas::unit(x, y, 5 + static_cast<std::uint32_t>(colour));
}
Field<float> wanted_light(int colour) {
  Field<float> plane(kCellsX, kCellsY);
  for (int y = 0; y < kCellsY; ++y)
    for (int x = 0; x < kCellsX; ++x) plane(x, y) = 0.8f * shown_at(colour, x, y) + 0.1f;
  return plane;
}
Field<float> shown_plane(int colour, int y0, int rows) {
  Field<float> plane(kCellsX * kPixels, rows);
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < plane.width(); ++x) plane(x, y) = shown_at(colour, x, y0 + y);
  return plane;
}
void report_pixels(benchmark::State& run, int colours, const LeastTime& least) {
  least.report(run, kCellsX * kCellsY * kPixels * kPixels * colours);
  run.SetItemsProcessed(run.iterations() * kCellsX * kCellsY * kPixels * kPixels * colours);
}

class Drop : public PictureSink {
 public:
  Result<void> write(const PictureStrip&) override { return {}; }
};

void LightLockStrips(benchmark::State& run) {
  ShadeRequest request;
  request.width = kCellsX * kPixels;
  request.height = kCellsY * kPixels;
  const LightPlanes light = {wanted_light(0), wanted_light(1), wanted_light(2)};
  const LightLockFrame frame = light_lock_frame(request, kCellsX, kCellsY);
  std::vector<Field<float>> planes;
  PictureStrip strip{0, request.height, {"R", "G", "B"}, {}};
  for (int c = 0; c < 3; ++c) planes.push_back(shown_plane(c, 0, request.height));
  for (const Field<float>& plane : planes) strip.plane.push_back(plane.view());
  const Threads threads(1);
  LeastTime least;
  for (auto _ : run)
    least.time([&] {
      Drop drop;
      LightLock lock(frame, light, threads, {&drop});
      if (!lock.write(strip)) run.SkipWithError("cannot write");
    });
  report_pixels(run, 3, least);
}

void LightLockPlainly(benchmark::State& run) {
  const Field<float> shown = shown_plane(0, 0, kCellsY * kPixels), wanted = wanted_light(0);
  LeastTime least;
  for (auto _ : run)
    least.time([&] {
      const reference::PlainLightLock twin(shown, wanted);
      double sum = 0;
      for (int y = 0; y < shown.height(); ++y)
        for (int x = 0; x < shown.width(); ++x) sum += twin.pixel(x, y);
      benchmark::DoNotOptimize(sum);
    });
  report_pixels(run, 1, least);
}

BENCHMARK(LightSky)->Iterations(40)->Unit(benchmark::kMillisecond);
BENCHMARK(LightSkyPlainly)->Iterations(4)->Unit(benchmark::kMillisecond);
BENCHMARK(LightLockStrips)->Iterations(8)->Unit(benchmark::kMillisecond);
BENCHMARK(LightLockPlainly)->Iterations(3)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pentimento
