// Converting recordings: samples per second, and bytes of memory per sample, of a generated
// recording of so many samples.
//   build/pentimento_bench --benchmark_filter=Convert

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "formats/import/sketch/recording.h"
#include "formats/import/sketch/sketch_log.h"

namespace pentimento::sketch {
namespace {

/// Strokes of 200 samples at 125 Hz, in the format of MyPaint.
std::string recording_of(std::int64_t samples) {
  constexpr std::int64_t kStroke = 200;
  std::string text;
  for (std::int64_t i = 0; i < samples; ++i) {
    const std::int64_t at = i % kStroke;
    const double along = static_cast<double>(at) / kStroke;
    text += fmt::format("{:.3f} {:.5f} {:.5f} {:.5f}\n", 0.008 * static_cast<double>(i),
                        100 + 500 * along, 100 + 300 * along * along,
                        at + 1 == kStroke ? 0 : 0.2 + 0.5 * along);
  }
  return text;
}

class NoFile : public log::Writer {
 public:
  void write(const log::Header&) override {}
  void write(const log::Event& event) override { benchmark::DoNotOptimize(event.time_us); }
  Result<Published> finish() override { return Published{}; }
};

void ConvertRead(benchmark::State& state) {
  const std::string text = recording_of(state.range(0));
  const Format* format = find_format("mypaint");
  for (auto _ : state) benchmark::DoNotOptimize(format->read({"a.dat", text}, {}));
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.counters["bytes_per_sample"] = sizeof(Sample);
}
BENCHMARK(ConvertRead)->Arg(10'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

void ConvertToEvents(benchmark::State& state) {
  const std::string text = recording_of(state.range(0));
  const Result<Sketch> sketch = find_format("mypaint")->read({"a.dat", text}, {});
  for (auto _ : state) {
    NoFile writer;
    if (!write_log(*sketch, {}, {}, writer)) return state.SkipWithError("no log");
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(ConvertToEvents)->Arg(10'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

/// With the text of the log, into a file.
void ConvertToFile(benchmark::State& state) {
  const std::string text = recording_of(state.range(0));
  const Result<Sketch> sketch = find_format("mypaint")->read({"a.dat", text}, {});
  const std::string path =
      std::filesystem::temp_directory_path() / "pentimento-convert-bench.jsonl";
  for (auto _ : state) {
    auto writer = log::Writer::create(path, log::Compression::kNone);
    if (!writer || !write_log(*sketch, {}, {}, **writer) || !(*writer)->finish())
      return state.SkipWithError("no log");
  }
  std::filesystem::remove(path);
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(ConvertToFile)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pentimento::sketch
