// Reading action logs: bytes and events per second of a generated session, at several sizes. Larger
// logs: PENTIMENTO_BENCH_LOG=FILE reads a given one instead, e.g. of 1 GB.

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <sys/resource.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "formats/log/summary.h"

namespace pentimento::log {
namespace {

/// A session of strokes of 120 samples at 120 Hz, as a recorder prints them.
void write_session(const std::string& path, std::int64_t events) {
  std::ofstream file(path, std::ios::binary);
  file << R"({"type":"header","format":"pentimento-log","version":1,)"
       << R"("canvas":{"width":1,"height":0.75}})"
       << "\n";
  constexpr std::int64_t kSamples = 120;
  for (std::int64_t i = 0; i < events; ++i) {
    const std::int64_t sample = i % kSamples;
    const char* phase = sample == 0 ? "down" : sample == kSamples - 1 ? "up" : "move";
    const double along = static_cast<double>(sample) / kSamples;
    file << fmt::format(
        R"({{"t":{:.6f},"type":"touch","phase":"{}","x":{:.5f},"y":{:.5f},"pressure":{:.4f}}})"
        "\n",
        static_cast<double>(i) / kSamples, phase, along, 0.5 * along * along, 0.5 + 0.3 * along);
  }
}

double peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

void read_all(benchmark::State& state, const std::string& path) {
  std::int64_t events = 0;
  for (auto _ : state) {
    auto reader = Reader::open(path, {});
    if (!reader) return state.SkipWithError(reader.error().message.c_str());
    const Result<Summary> summary = summarize(**reader);
    if (!summary) return state.SkipWithError(summary.error().message.c_str());
    events += summary->event_count;
  }
  const auto size = static_cast<std::int64_t>(std::filesystem::file_size(path));
  state.SetBytesProcessed(state.iterations() * size);
  state.SetItemsProcessed(events);
  state.counters["file_MB"] = static_cast<double>(size) / 1e6;
  state.counters["peak_memory_MB"] = peak_memory_bytes() / 1e6;
}

/// Checks, hash and summary of a log of range(0) events.
void ReadLog(benchmark::State& state) {
  if (const char* given = std::getenv("PENTIMENTO_BENCH_LOG")) {
    read_all(state, given);
    return;
  }
  const std::string path = std::filesystem::temp_directory_path() / "pentimento-log-bench.jsonl";
  write_session(path, state.range(0));
  read_all(state, path);
  std::filesystem::remove(path);
}
BENCHMARK(ReadLog)->Arg(1'000)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pentimento::log
