#include "replay/paper/grain.h"

#include <algorithm>

#include "core/base/random.h"

namespace pentimento {

namespace {
constexpr int kCoarsest = 12;
constexpr int kOctaves = 4;       // of the bumps
constexpr int kToothOctaves = 4;  // of what only fine cells show

/// Random height of a lattice point; indices wrap, so that the repeat closes.
double lattice(int points, int i, int j) {
  const auto column = static_cast<std::uint64_t>(i % points);
  const auto row = static_cast<std::uint64_t>(j % points);
  const auto n = static_cast<std::uint64_t>(points);
  return static_cast<double>(random_uniform(RandomPurpose::kPaperRelief, n, row * n + column));
}

double smooth(double t) {
  return t * t * (3 - 2 * t);
}

/// Value noise of one lattice at u, v >= 0 in lattice units.
double noise(int points, double u, double v) {
  const int i = static_cast<int>(u);
  const int j = static_cast<int>(v);
  const double a = smooth(u - i);
  const double b = smooth(v - j);
  const double top = lattice(points, i, j) * (1 - a) + lattice(points, i + 1, j) * a;
  const double bottom = lattice(points, i, j + 1) * (1 - a) + lattice(points, i + 1, j + 1) * a;
  return top * (1 - b) + bottom * b;
}

double wrapped(double turns) {
  return turns - static_cast<double>(static_cast<std::int64_t>(turns));
}

double height_at(const RepeatGrid& grid, double u, double v) {
  double sum = 0;
  double total = 0;
  double weight = 1;
  int points = kCoarsest;
  for (int octave = 0; octave < kOctaves; ++octave, points *= 2, weight /= 2) {
    const double cells = std::min(grid.cells_per_repeat_x, grid.cells_per_repeat_y) / points;
    const double fade = std::clamp(cells - 1, 0.0, 1.0);
    const double value = fade > 0 ? noise(points, u * points, v * points) : 0.5;
    sum += weight * (0.5 + fade * (value - 0.5));
    total += weight;
  }
  for (int octave = 0; octave < kToothOctaves; ++octave, points *= 2, weight /= 2) {
    const double cells = std::min(grid.cells_per_repeat_x, grid.cells_per_repeat_y) / points;
    const double fade = std::clamp(cells - 1, 0.0, 1.0);
    if (fade > 0) sum += weight * fade * (noise(points, u * points, v * points) - 0.5);
  }
  return std::clamp(sum / total, 0.0, 1.0);
}
}  // namespace

void grain_row(const RepeatGrid& grid, int x, int y, std::span<float> out) {
  const double v = wrapped((y + 0.5) / grid.cells_per_repeat_y);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double u = wrapped((x + static_cast<int>(i) + 0.5) / grid.cells_per_repeat_x);
    out[i] = static_cast<float>(height_at(grid, u, v));
  }
}

}  // namespace pentimento
