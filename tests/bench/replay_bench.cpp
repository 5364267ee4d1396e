// How fast a log is turned into cues, and played on a small canvas, without and with the hashes of
// each step.

#include <benchmark/benchmark.h>

#include <cstdint>
#include <optional>
#include <utility>

#include "replay/hashes/field_hashes.h"
#include "replay/hashes/hash_recorder.h"
#include "replay/play/player.h"
#include "replay/session/log_plan.h"
#include "tests/bench/least_time.h"
#include "tests/replay/list_reader.h"

namespace pentimento {
namespace {

/// `strokes` strokes of a second at 120 samples a second, gravity at 60 Hz between them.
test::ListReader session(int strokes) {
  test::ListReader reader;
  for (int i = 0; i < strokes; ++i) {
    const double t = 1.2 * i;
    reader.stroke(t, t + 1, 0.1, 0.9, 0.1 + 0.5 * (i % 10) / 10, 120);
    for (int k = 0; k < 12; ++k) reader.add(t + 1 + k / 60.0, log::Gravity{0.1, 0.2, 9.8});
  }
  return reader;
}

void TimelineEvents(benchmark::State& bench) {
  test::ListReader reader = session(static_cast<int>(bench.range(0)));
  LogFiles files("-", false);
  const BrushTable brushes;
  for (auto _ : bench) {
    const LogPlan plan = plan_log(reader, files, {}).value();
    Timeline timeline(reader, {plan.undo, brushes, plan.stepped, 1});
    std::int64_t cues = 0;
    while (timeline.next().value().has_value()) ++cues;
    benchmark::DoNotOptimize(cues);
    static_cast<void>(reader.rewind());
  }
  bench.SetItemsProcessed(bench.iterations() * static_cast<std::int64_t>(reader.events.size()));
  bench.SetLabel("events");
}
BENCHMARK(TimelineEvents)->Arg(10)->Arg(100)->Unit(benchmark::kMillisecond);

void PlayerSteps(benchmark::State& bench) {
  const int side = static_cast<int>(bench.range(0));
  const Threads threads(static_cast<int>(bench.range(1)));
  test::ListReader reader = session(2);
  LogFiles files("-", false);
  const BrushTable brushes;
  const Control control;
  const bool hashed = bench.range(2) != 0;
  std::int64_t steps = 0;
  for (auto _ : bench) {
    const LogPlan plan = plan_log(reader, files, {}).value();
    SimulationSetup setup;
    setup.geometry = {side, side * 3 / 4, 1.0, 0.75};
    setup.basis = make_channels(plan.palette.pigments());
    setup.paper_m = Field<float>(side, side * 3 / 4);
    Simulation simulation(std::move(setup), threads);
    Timeline timeline(reader, {plan.undo, brushes, plan.stepped, 1});
    Hand hand(simulation, {brushes, plan.palette, 0, files, std::nullopt});
    LightingTrack lighting(default_lighting(), 45);
    const float tile_m = simulation.model().sleep_tile_m;
    const auto file = HashWriter::create("/dev/null", {}, false);
    HashRecorder recorder(simulation.geometry(), tile_m, threads, **file);
    Player player({timeline, simulation, hand, lighting, files, control, plan.steps,
                   hashed ? &recorder : nullptr});
    benchmark::DoNotOptimize(player.play_all(plan.steps).ok());
    steps += player.steps();
    static_cast<void>(reader.rewind());
  }
  bench.SetItemsProcessed(steps);
  bench.SetLabel("steps");
}
BENCHMARK(PlayerSteps)
    ->ArgNames({"side", "threads", "hashes"})
    ->Args({256, 1, 0})
    ->Args({1024, 1, 0})
    ->Args({1024, 1, 1})
    ->Args({1024, 2, 0})
    ->Args({1024, 2, 1})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// Hashing all of a canvas of 1024 x 768 cells, 2 layers of 4 channels. An item is a cell.
void ReplayHashes(benchmark::State& bench) {
  CanvasState state = make_canvas_state({1024, 768, 1, 0.75}, 2, 4, 3, 0.9f);
  state.depth_m.fill(0.002f);
  for (Field<float>& plane : state.pigment) plane.fill(0.001f);
  FieldHashes hashes(state.geometry, 1.0f / 32);
  const Threads threads(1);
  LeastTime least;
  for (auto _ : bench) least.time([&] { hashes.update(state, threads, true); });
  least.report(bench, 1024 * 768);
  bench.SetItemsProcessed(bench.iterations() * 1024 * 768);
}
BENCHMARK(ReplayHashes)->Iterations(8)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pentimento
