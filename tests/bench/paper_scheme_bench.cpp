// The published fluid: each pass and the whole step, on a canvas that is wet all over and sloshes,
// with 2 layers and 4 channels; then the step on canvases with less to do. Arguments: width,
// height, threads. `ns_per_cell` is per cell of the canvas: of a pass by processor time, of a step
// by the clock.

#include <benchmark/benchmark.h>

#include "core/base/approx.h"
#include "core/base/random.h"
#include "core/fluid/paper/depth.h"
#include "core/fluid/paper/gravity.h"
#include "core/fluid/paper/height_sweep.h"
#include "core/fluid/paper/height_system.h"
#include "core/fluid/paper/paper_scheme.h"
#include "core/fluid/paper/pigment.h"
#include "core/fluid/paper/trace.h"
#include "core/fluid/paper/velocity_limits.h"
#include "core/fluid/paper/viscosity.h"
#include "core/fluid/paper/wet_front.h"
#include "core/fluid/rheology.h"
#include "tests/bench/least_time.h"

namespace pentimento::paper {
namespace {

constexpr int kLayers = 2, kChannels = 4;
constexpr int kPasses = 12;  // enough to be told from noise, quick to be repeated

/// Wet cells [0, wet_width) x [0, wet_height): 5 to 15 mm deep, theta 2 to 18, moving at 0.1 m/s.
struct Canvas {
  Canvas(int width, int height, int thread_count, int wet_width, int wet_height)
      : threads(thread_count),
        contact(make_brush_contact(width, height)),
        state(make_canvas_state({width, height, 1, 1}, kLayers, kChannels, 3, 0.9f)),
        planes(make_planes(width, height, kChannels)) {
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const float fx = static_cast<float>(x) / 50, fy = static_cast<float>(y) / 40;
        state.base_m(x, y) =
            3e-4f * random_uniform(RandomPurpose::kPaperRelief, static_cast<unsigned>(x),
                                   static_cast<unsigned>(y));
        if (x >= wet_width || y >= wet_height) continue;
        state.depth_m(x, y) = 0.01f + 0.005f * approx::sin(fx);
        state.velocity_x_m_s(x, y) = 0.1f * approx::cos(fy);
        state.velocity_y_m_s(x, y) = 0.1f * approx::sin(fx + fy);
        for (Field<float>& p : state.pigment) p(x, y) = 0.012f * (1 + approx::cos(fx + 2 * fy));
      }
  }
  int width() const { return state.geometry.width; }
  int height() const { return state.geometry.height; }
  Columns columns() const { return {0, width()}; }
  StepInput input() const { return {model, gravity, 1.0f / 45, contact, amount, threads}; }

  Model model;
  Vec3f gravity{0.5f, -0.5f, 9.7f};
  std::vector<float> amount = std::vector<float>(kChannels, 1.0f);
  Threads threads;
  BrushContact contact;
  CanvasState state;
  Planes planes;
};

void report(benchmark::State& run) {
  const double cells = static_cast<double>(run.range(0)) * static_cast<double>(run.range(1));
  run.counters["ns_per_cell"] = benchmark::Counter(
      cells * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  run.SetItemsProcessed(run.iterations() * run.range(0) * run.range(1));
}

/// Times body(canvas, constants, y) over all rows.
template <typename Body>
void time_pass(benchmark::State& run, Body body) {
  const int width = static_cast<int>(run.range(0)), height = static_cast<int>(run.range(1));
  Canvas canvas(width, height, static_cast<int>(run.range(2)), width, height);
  const StepConstants k = make_step_constants(canvas.state.geometry, canvas.input());
  Planes& p = canvas.planes;
  for (int y = 0; y < height; ++y) prepare_margin_row(canvas.state, y, {0, width}, {}, p);
  p.mobility_frac.fill(0.5f);
  p.viscosity_m2_s.fill(5e-3f);
  p.occupied.fill(2);
  p.free_frac.fill(0.5f);
  p.moved.fill(1);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      for (std::size_t i = 0; i < 3; ++i) {
        p.u_m_s[i](x, y) = canvas.state.velocity_x_m_s(x, y);
        p.v_m_s[i](x, y) = canvas.state.velocity_y_m_s(x, y);
      }
      p.system.centre(x, y) = 0.2f * p.height_m[0](x, y);
      p.system.left(x, y) = p.system.right(x, y) = p.system.up(x, y) = p.system.down(x, y) = 0.2f;
    }
  LeastTime least;
  for (auto _ : run)
    least.time([&] { canvas.threads.for_rows(height, [&](int y) { body(canvas, k, y); }); });
  least.report(run, static_cast<double>(width) * height);
  report(run);
}

void BM_Prepare(benchmark::State& run) {
  time_pass(run, [](Canvas& c, const StepConstants&, int y) {
    prepare_margin_row(c.state, y, c.columns(), c.columns(), c.planes);
  });
}

void BM_Rheology(benchmark::State& run) {
  time_pass(run, [rheology = make_rheology(Model{})](Canvas& c, const StepConstants& k, int y) {
    const auto row = [&](Field<float>& f) {
      return std::span<float>(f.row(y), static_cast<std::size_t>(c.width()));
    };
    total_amount_row(c.state, c.amount, y, 0, c.width(), row(c.planes.system.left));
    rheology_row(rheology, k.dry_film_m, row(c.state.depth_m), row(c.planes.system.left),
                 row(c.planes.mobility_frac), row(c.planes.viscosity_m2_s));
  });
}

void BM_Trace(benchmark::State& run) {
  time_pass(run, [](Canvas& c, const StepConstants& k, int y) {
    Planes& p = c.planes;
    trace_row(k, c.state, y, c.columns(),
              {p.u_m_s[0].row(y), p.v_m_s[0].row(y), p.system.centre.row(y), p.mobility_frac});
  });
}

void BM_HeightSystem(benchmark::State& run) {
  time_pass(run, [](Canvas& c, const StepConstants& k, int y) {
    build_height_system_row(k, c.state, y, c.columns(), c.planes);
  });
}

void BM_HeightSweep(benchmark::State& run) {
  time_pass(run, [](Canvas& c, const StepConstants&, int y) {
    sweep_height_row(c.planes.system, c.planes.height_m[0], y, c.columns(),
                     c.planes.height_m[1].row(y));
  });
}

void BM_Gravity(benchmark::State& run) {
  time_pass(run, [](Canvas& c, const StepConstants& k, int y) {
    accelerate_row(k, c.state, c.planes.height_m[0], y, c.columns(), c.planes);
  });
}

void BM_ViscositySystem(benchmark::State& run) {
  time_pass(run, [](Canvas& c, const StepConstants& k, int y) {
    build_viscosity_row(k, y, c.columns(), c.planes);
  });
}

void BM_ViscositySweep(benchmark::State& run) {
  time_pass(run, [](Canvas& c, const StepConstants&, int y) {
    Planes& p = c.planes;
    sweep_viscosity_row(p.system, {p.u_m_s[0], p.v_m_s[0]}, {p.u_m_s[1], p.v_m_s[1]}, y,
                        c.columns(), p.u_m_s[2].row(y), p.v_m_s[2].row(y));
  });
}

void BM_SpeedLimits(benchmark::State& run) {
  time_pass(run, [](Canvas& c, const StepConstants& k, int y) {
    Planes& p = c.planes;
    limit_speed_row(k, c.columns(), p.u_m_s[0].row(y), p.v_m_s[0].row(y));
    mark_moved_row(c.state, y, c.columns(), p.u_m_s[0].row(y), p.v_m_s[0].row(y), p.moved.row(y));
  });
}

void BM_Depth(benchmark::State& run) {
  time_pass(run, [](Canvas& c, const StepConstants&, int y) {
    benchmark::DoNotOptimize(
        update_depth_row(c.planes, c.planes.height_m[0], y, c.columns(), c.state));
  });
}

void BM_PigmentOfOneLayer(benchmark::State& run) {
  const int layer = static_cast<int>(run.range(3));
  time_pass(run, [layer](Canvas& c, const StepConstants& k, int y) {
    Planes& p = c.planes;
    advect_pigment_row(k, c.state, layer, p.u_m_s[0].row(y), p.v_m_s[0].row(y), y, c.columns(), p);
  });
}

void BM_StorePigmentOfOneLayer(benchmark::State& run) {
  time_pass(run, [](Canvas& c, const StepConstants&, int y) {
    benchmark::DoNotOptimize(store_pigment_row(c.planes, 0, y, c.columns(), c.state));
  });
}

void BM_CountAndLoosenLayers(benchmark::State& run) {
  time_pass(run, [](Canvas& c, const StepConstants&, int y) {
    count_layers_row(c.state, y, c.columns(), c.planes);
    find_free_row(c.state, c.amount, c.model.pigment_residue, y, c.columns(), c.planes);
  });
}

void BM_FrontAndVelocity(benchmark::State& run) {
  time_pass(run, [](Canvas& c, const StepConstants& k, int y) {
    Planes& p = c.planes;
    const Velocity velocity{p.u_m_s[0], p.v_m_s[0]};
    advance_front_along_row(k, c.state, c.contact, velocity, y, c.columns(), p.inflow);
    advance_front_along_columns(k, c.state, c.contact, velocity, c.columns(), y, y + 1, p.inflow);
    benchmark::DoNotOptimize(
        update_velocity_row(c.contact, velocity, p.inflow, y, c.columns(), c.state));
  });
}

/// Whole steps; the wet corner is `part` of the canvas in both directions.
void time_step(benchmark::State& run, double part, bool moving) {
  const int width = static_cast<int>(run.range(0)), height = static_cast<int>(run.range(1));
  Canvas canvas(width, height, static_cast<int>(run.range(2)), static_cast<int>(part * width),
                static_cast<int>(part * height));
  if (!moving) canvas.model.velocity_threshold_m_s = 1e3f;  // everything stands
  PaperScheme scheme(canvas.state.geometry, kLayers, kChannels);
  scheme.step(canvas.state, canvas.input());
  int step = 0;
  for (auto _ : run) {
    canvas.gravity.x = ++step % 20 < 10 ? 0.5f : -0.5f;
    benchmark::DoNotOptimize(scheme.step(canvas.state, canvas.input()));
  }
  report(run);
}

void BM_StepAllMoving(benchmark::State& run) {
  time_step(run, 1, true);
}
void BM_StepAllAtRest(benchmark::State& run) {
  time_step(run, 1, false);
}
void BM_StepPatchOfOneSixteenth(benchmark::State& run) {
  time_step(run, 0.25, true);
}
void BM_StepDry(benchmark::State& run) {
  time_step(run, 0, true);
}

void sizes(benchmark::internal::Benchmark* b) {
  for (int threads : {1, 2})
    for (int k : {1, 2}) b->Args({1024 * k, 768 * k, threads});
  b->UseRealTime()->Unit(benchmark::kMillisecond);
}
void pass_sizes(benchmark::internal::Benchmark* b) {
  b->Args({1024, 768, 1})->Args({2048, 1536, 1});
  b->Iterations(kPasses)->Unit(benchmark::kMillisecond);
}
void layer_sizes(benchmark::internal::Benchmark* b) {
  for (int layer : {0, 1}) b->Args({1024, 768, 1, layer})->Args({2048, 1536, 1, layer});
  b->Iterations(kPasses)->Unit(benchmark::kMillisecond);
}

BENCHMARK(BM_Prepare)->Apply(pass_sizes);
BENCHMARK(BM_Rheology)->Apply(pass_sizes);
BENCHMARK(BM_Trace)->Apply(pass_sizes);
BENCHMARK(BM_HeightSystem)->Apply(pass_sizes);
BENCHMARK(BM_HeightSweep)->Apply(pass_sizes);
BENCHMARK(BM_Gravity)->Apply(pass_sizes);
BENCHMARK(BM_ViscositySystem)->Apply(pass_sizes);
BENCHMARK(BM_ViscositySweep)->Apply(pass_sizes);
BENCHMARK(BM_SpeedLimits)->Apply(pass_sizes);
BENCHMARK(BM_Depth)->Apply(pass_sizes);
BENCHMARK(BM_CountAndLoosenLayers)->Apply(pass_sizes);
BENCHMARK(BM_PigmentOfOneLayer)->Apply(layer_sizes);
BENCHMARK(BM_StorePigmentOfOneLayer)->Apply(pass_sizes);
BENCHMARK(BM_FrontAndVelocity)->Apply(pass_sizes);
BENCHMARK(BM_StepAllMoving)->Apply(sizes);
BENCHMARK(BM_StepAllAtRest)->Apply(sizes);
BENCHMARK(BM_StepPatchOfOneSixteenth)->Apply(sizes);
BENCHMARK(BM_StepDry)->Apply(sizes);

}  // namespace
}  // namespace pentimento::paper
