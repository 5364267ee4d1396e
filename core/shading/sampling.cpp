#include "core/shading/sampling.h"

#include <cmath>

#include "core/base/check.h"

namespace pentimento {
namespace {

constexpr int kCellsAfter = 2;

/// Position of a sample in cells; whole numbers are centres of cells.
double position(const SampleAxis& axis, long long sample) {
  const double samples = static_cast<double>(axis.pixels) * axis.per_pixel;
  return (static_cast<double>(sample) + 0.5) * axis.cells / samples - 0.5;
}

}  // namespace

int SampleAxis::most_cells(int count) const {
  const double cells_a_pixel = static_cast<double>(cells) / pixels;
  return static_cast<int>(std::ceil(count * cells_a_pixel)) + kCellsBefore + kCellsAfter + 2;
}

int samples_per_pixel(int cells, int pixels) {
  return cells <= pixels ? 1 : (cells + pixels - 1) / pixels;
}

bool averages_cells(int cells_x, int cells_y, int pixels_x, int pixels_y) {
  if (pixels_x > cells_x || pixels_y > cells_y) return false;
  const int n = samples_per_pixel(cells_x, pixels_x);
  return n > kMostCellsOfPixel || pixels_x * n != cells_x || pixels_y * n != cells_y;
}

AxisWindow axis_window(const SampleAxis& axis, int first_pixel, int count) {
  PENTIMENTO_CHECK(count > 0 && first_pixel >= 0 && first_pixel + count <= axis.pixels);
  const long long first = static_cast<long long>(first_pixel) * axis.per_pixel;
  const long long samples = static_cast<long long>(count) * axis.per_pixel;
  AxisWindow window;
  window.first_cell = static_cast<int>(std::floor(position(axis, first))) - kCellsBefore;
  const int last = static_cast<int>(std::floor(position(axis, first + samples - 1)));
  window.cells = last + kCellsAfter + 1 - window.first_cell;
  window.table.reserve(static_cast<std::size_t>(2 * samples));
  for (long long s = first; s < first + samples; ++s) {
    const double at = position(axis, s), cell = std::floor(at);
    window.table.push_back(static_cast<float>(cell - window.first_cell));
    window.table.push_back(static_cast<float>(at - cell));
  }
  return window;
}

}  // namespace pentimento
