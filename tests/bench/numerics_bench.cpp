// The tables of docs/numerics.md that accuracy_bench.cpp and drift_bench.cpp do not make.
//   build/pentimento_bench --benchmark_filter='^Numerics' --benchmark_counters_tabular=true

#include <benchmark/benchmark.h>

#include "tests/core/fluid/analytic_case.h"
#include "tests/core/fluid/conservative/basin.h"

namespace pentimento::conservative {
namespace {

// What a shear wave of 64 cells keeps of exp(-nu k^2 t), minus 1. Argument: 1000 nu k^2 dt.
void NumericsShear(benchmark::State& state) {
  constexpr double kPi = 3.14159265358979323846;
  const double k = 2 * kPi / 0.064;
  double error = 0;
  for (auto _ : state) {
    Basin b({96, 64, 0.096, 0.064});
    b.model = ideal_fluid(0.005);
    b.model.nu_min_m2_s = b.model.nu_max_m2_s = 1e-4f;
    b.fill_depth([](int, int) { return 0.005f; });
    b.gravity_m_s2 = {0, 0, 0};
    b.dt_s = static_cast<float>(1e-3 * static_cast<double>(state.range(0)) / (1e-4 * k * k));
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 95; ++x)
        b.state.velocity_x_m_s(x, y) = static_cast<float>(1e-4 * std::cos(k * (y + 0.5) * 1e-3));
    const int steps = static_cast<int>(1000 / state.range(0));  // to exp(-1)
    b.steps(steps);
    const double left =
        static_cast<double>(b.state.velocity_x_m_s(48, 0)) / 1e-4 / std::cos(k * 0.5e-3);
    error = left / std::exp(-1e-3 * static_cast<double>(state.range(0) * steps)) - 1;
  }
  state.counters["error_percent"] = 100 * error;
}
BENCHMARK(NumericsShear)->Arg(200)->Arg(100)->Arg(50)->Arg(10)->Iterations(1);

// Terminal speed of a film over g d^2 / (3 nu), minus 1. Arguments: depth in um, steps.
void NumericsFilm(benchmark::State& state) {
  const double depth = 1e-6 * static_cast<double>(state.range(0));
  double error = 0, expected = 0;
  for (auto _ : state) {
    Basin b({1024, 8, 1.024, 0.008});
    b.model.gravity_cutoff_frac = 0;
    b.model.velocity_threshold_m_s = 0;
    b.fill_depth([&](int, int) { return static_cast<float>(depth); });
    b.gravity_m_s2 = {4, 0, 0};
    b.steps(static_cast<int>(state.range(1)));
    expected = 4 * depth * depth / 3e-3;
    error = static_cast<double>(-b.state.velocity_x_m_s(700, 4)) / expected - 1;
  }
  state.counters["expected_mm_s"] = 1000 * expected;
  state.counters["error_percent"] = 100 * error;
}
BENCHMARK(NumericsFilm)
    ->Args({500, 20})
    ->Args({1000, 20})
    ->Args({2000, 20})
    ->Args({2000, 60})
    ->Args({4000, 60})
    ->Iterations(1);

// What is left of a checkerboard, percent. Arguments: 0 height, 1 velocity; steps.
void NumericsOddEven(benchmark::State& state) {
  double left = 0;
  const bool height = state.range(0) == 0;
  for (auto _ : state) {
    Basin b({64, 64, 0.064, 0.064});
    b.model.velocity_threshold_m_s = 0;
    const auto sign = [](int x, int y) { return (x + y) % 2 == 0 ? 1.0f : -1.0f; };
    if (height) {
      b.model.bed_friction = 0;
      b.model.friction_viscosity_floor_m2_s = 0;
      b.fill_depth([&](int x, int y) { return 0.01f + 0.001f * sign(x, y); });
    } else {
      b.fill_depth([](int, int) { return 0.01f; });
      for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 63; ++x) b.state.velocity_x_m_s(x, y) = 0.005f * sign(x, y);
    }
    b.steps(static_cast<int>(state.range(1)));
    left = height ? (highest(b.state.depth_m) - lowest(b.state.depth_m)) / 0.002
                  : highest(b.state.velocity_x_m_s) / 0.005;
  }
  state.counters["left_percent"] = 100 * left;
}
BENCHMARK(NumericsOddEven)->ArgsProduct({{0, 1}, {1, 2, 3}})->Iterations(1);

// Deepest cell within nine steps of a slide of 10 mm, in mm. Argument: 100 most_cells_moved.
void NumericsParts(benchmark::State& state) {
  double deepest = 0;
  for (auto _ : state) {
    Basin b({256, 192, 0.25, 0.1875});
    b.model.most_cells_moved = static_cast<float>(state.range(0)) / 100;
    b.model.most_parts_of_step = 100;
    b.gravity_m_s2 = {2, -5, 8};
    for (int y = 50; y < 140; ++y)
      for (int x = 60; x < 190; ++x) {
        b.state.depth_m(x, y) = 0.01f;
        b.state.channel(0, 0)(x, y) = 0.02f;
      }
    b.steps(9);
    deepest = b.statistic("max_depth_m");
  }
  state.counters["deepest_mm"] = 1000 * deepest;
}
BENCHMARK(NumericsParts)
    ->Arg(100000)
    ->Arg(200)
    ->Arg(150)
    ->Arg(125)
    ->Arg(120)
    ->Arg(100)
    ->Arg(50)
    ->Iterations(1);

Basin tilted_patch(float theta_per_m, int viscosity_cycles, int height_cycles) {
  Basin b({128, 96, 0.128, 0.096});
  b.model.viscosity_cycles = viscosity_cycles;
  b.model.height_cycles = height_cycles;
  b.gravity_m_s2 = {2, -4, 8};
  for (int y = 20; y < 70; ++y)
    for (int x = 24; x < 100; ++x) {
      const float d = 0.0015f + 0.0135f * static_cast<float>((x * 7 + y * 13) % 40) / 40;
      b.state.depth_m(x, y) = d;
      b.state.channel(0, 0)(x, y) = theta_per_m * d;
    }
  b.steps(40);
  return b;
}

// Against 20 + 20 cycles. Arguments: viscosity cycles, height cycles, theta.
void NumericsCycles(benchmark::State& state) {
  double share = 0;
  for (auto _ : state) {
    const auto theta = static_cast<float>(state.range(2));
    const Basin all = tilted_patch(theta, 20, 20);
    const Basin few =
        tilted_patch(theta, static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    double off = 0;
    for (int y = 0; y < 96; ++y)
      for (int x = 0; x < 128; ++x)
        off += std::abs(static_cast<double>(few.state.depth_m(x, y) - all.state.depth_m(x, y)));
    share = off / total(all.state.depth_m);
  }
  state.counters["difference"] = share;
}
BENCHMARK(NumericsCycles)
    ->Args({1, 1, 2})
    ->Args({1, 2, 2})
    ->Args({1, 3, 2})
    ->Args({2, 3, 2})
    ->Args({3, 3, 2})
    ->Args({5, 4, 2})
    ->Args({1, 1, 10})
    ->Args({1, 2, 10})
    ->Args({1, 3, 10})
    ->Args({2, 3, 10})
    ->Args({3, 3, 10})
    ->Args({5, 4, 10})
    ->Iterations(1);

// Seconds until a square of 4 cm sleeps. Arguments: depth in mm, theta, 45 degrees or level.
void NumericsRest(benchmark::State& state) {
  double seconds = 0;
  for (auto _ : state) {
    Basin b({256, 192, 0.25, 0.1875});
    for (int y = 76; y < 116; ++y)
      for (int x = 108; x < 148; ++x) {
        b.state.depth_m(x, y) = static_cast<float>(state.range(0)) * 1e-3f;
        b.state.channel(0, 0)(x, y) = static_cast<float>(state.range(0) * state.range(1)) * 1e-3f;
      }
    if (state.range(2) != 0) b.gravity_m_s2 = {0, -6.937f, 6.937f};
    int steps = 0;
    while (steps < 300 * 45 && b.step()) ++steps;
    seconds = steps / 45.0;
  }
  state.counters["rest_s"] = seconds;
}
BENCHMARK(NumericsRest)
    ->ArgsProduct({{1, 3, 10}, {2, 9, 13, 28}, {0, 1}})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

// A minute of shaking at 10 Hz, +-20 m/s^2 along x and z, +-6 along y, of 3 and 6 mm on a weave.
void NumericsShake(benchmark::State& state) {
  constexpr int kWidth = 256, kHeight = 192;
  double medium = 0, pigment = 0, deepest = 0, fastest = 0;
  for (auto _ : state) {
    Basin b({kWidth, kHeight, 0.25, 0.1875});
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        b.state.base_m(x, y) = 1e-4f * static_cast<float>((x * 7 + y * 3) % 4);
        b.state.depth_m(x, y) = (x / 20 + y / 20) % 2 == 0 ? 0.003f : 0.006f;
        b.state.channel(0, 0)(x, y) = (x / 30) % 2 == 0 ? 0.005f : 0.06f;
      }
    b.step();
    const double depth = total(b.state.depth_m);
    const double amount = total(b.state.channel(0, 0));
    for (int i = 0; i < 60 * 45; ++i) {
      const double phase = 2 * 3.14159265358979 * 10 * i / 45;
      const auto sine = static_cast<float>(std::sin(phase));
      b.gravity_m_s2 = {20 * sine, 6 * static_cast<float>(std::cos(phase)), -20 * sine};
      b.step();
    }
    medium = total(b.state.depth_m) / depth - 1;
    pigment = total(b.state.channel(0, 0)) / amount - 1;
    deepest = b.statistic("max_depth_m");
    fastest = b.statistic("max_speed_m_s");
  }
  state.counters["medium"] = medium;
  state.counters["pigment"] = pigment;
  state.counters["deepest_mm"] = 1000 * deepest;
  state.counters["fastest"] = fastest;
}
BENCHMARK(NumericsShake)->Iterations(1)->Unit(benchmark::kSecond);

// A wash of 4 mm, 3.5 /m, in one layer or half in each of two, after 120 steps at 28 degrees.
void NumericsLayers(benchmark::State& state) {
  const int layers = static_cast<int>(state.range(0));
  double deepest = 0, most = 0, over = 0;
  for (auto _ : state) {
    Basin b({128, 96, 0.125, 0.09375}, layers, layers);
    b.gravity_m_s2 = {1.5f, -4.5f, 8};
    b.fill_depth([](int x, int y) {
      const float r = std::hypot(static_cast<float>(x - 60) / 40, static_cast<float>(y - 30) / 18);
      return r < 1 ? 0.004f * (1 - r * r * r * r) : 0.0f;
    });
    for (int y = 0; y < 96; ++y)
      for (int x = 0; x < 128; ++x)
        for (int k = 0; k < layers; ++k)
          b.state.channel(k, k)(x, y) = 3.5f * b.state.depth_m(x, y) / static_cast<float>(layers);
    b.steps(120);
    deepest = highest(b.state.depth_m);
    int wet = 0, thick = 0;
    for (int y = 0; y < 96; ++y)
      for (int x = 0; x < 128; ++x) {
        const float depth = b.state.depth_m(x, y);
        if (depth < b.model.dry_film_m()) continue;
        float theta = 0;
        for (int k = 0; k < layers; ++k) theta += b.state.channel(k, k)(x, y) / depth;
        most = std::max(most, static_cast<double>(theta));
        ++wet;
        thick += theta > 1.5f * 3.5f ? 1 : 0;
      }
    over = 100.0 * thick / wet;
  }
  state.counters["deepest_mm"] = 1000 * deepest;
  state.counters["most_per_m"] = most;
  state.counters["over_percent"] = over;
}
BENCHMARK(NumericsLayers)->Arg(1)->Arg(2)->Iterations(1);

}  // namespace
}  // namespace pentimento::conservative
