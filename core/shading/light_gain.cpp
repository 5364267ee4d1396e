#include "core/shading/light_gain.h"

#include <algorithm>
#include <cstdint>

#include "core/base/kernel.h"

namespace pentimento {
namespace {
constexpr float kFloor = 0.002f;  // of white's light
constexpr float kStep = 2;        // a cell's ratio a round

/// Position of a pixel's centre in units of half a pixel, times the number of cells.
std::int64_t centre(const GainAxis& axis, int pixel) {
  return (2 * std::int64_t{pixel} + 1) * axis.cells;
}

/// Adds a row of pixels to the sums of its columns, under each of the row's weights.
PENTIMENTO_KERNEL
void add_pixels(const float* light, const std::array<float, 3>& down, int n,
                float* __restrict above, float* __restrict own, float* __restrict below) {
  const float w0 = down[0], w1 = down[1], w2 = down[2];
  for (int x = 0; x < n; ++x) {
    above[x] += w0 * light[x];
    own[x] += w1 * light[x];
    below[x] += w2 * light[x];
  }
}
}  // namespace

int GainAxis::cell_of(int pixel) const {
  return static_cast<int>(centre(*this, pixel) / (2 * std::int64_t{pixels}));
}

int GainAxis::first_pixel(int cell) const {
  const std::int64_t above = 2 * std::int64_t{pixels} * cell - cells, per = 2 * std::int64_t{cells};
  return above <= 0 ? 0 : static_cast<int>((above + per - 1) / per);
}

GainLine::GainLine(const GainAxis& axis, PixelRun cell_run) {
  pixel_run.first = axis.first_pixel(cell_run.first);
  for (int c = cell_run.first; c <= cell_run.first + cell_run.count; ++c)
    begin.push_back(axis.first_pixel(c) - pixel_run.first);
  pixel_run.count = begin.back();
  const double span = 2.0 * axis.pixels;
  for (int p = pixel_run.first; p < pixel_run.first + pixel_run.count; ++p) {
    const double in_cell = static_cast<double>(centre(axis, p)) / span - axis.cell_of(p);
    const double before = 0.5 * (1 - in_cell) * (1 - in_cell), after = 0.5 * in_cell * in_cell;
    weight.push_back({static_cast<float>(before), static_cast<float>(1 - before - after),
                      static_cast<float>(after)});
  }
}

void gain_pixels(const GainLine& across, int i, const std::array<float, 3>& down,
                 const GainRows& gain, float* out) {
  const auto column = [&](int cell) {
    const auto c = std::clamp(cell, 0, across.cells() - 1);
    return down[0] * gain[0][c] + down[1] * gain[1][c] + down[2] * gain[2][c];
  };
  const float before = column(i - 1), own = column(i), after = column(i + 1);
  const auto at = static_cast<std::size_t>(i);
  for (auto p = static_cast<std::size_t>(across.begin[at]);
       p < static_cast<std::size_t>(across.begin[at + 1]); ++p) {
    const std::array<float, 3>& w = across.weight[p];
    *out++ = w[0] * before + w[1] * own + w[2] * after;
  }
}

void find_gain_moments(const GainLine& across, int first, int last,
                       std::span<const float* const> light, const std::array<float, 3>* down,
                       float* moment) {
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const int left = across.begin[at(first)], columns = across.begin[at(last)] - left;
  std::vector<float> sums(3 * at(columns), 0.0f);
  const std::array<float*, 3> column{&sums[0], sums.data() + columns, sums.data() + 2 * columns};
  for (const float* row : light)
    add_pixels(row + left, *down++, columns, column[0], column[1], column[2]);
  const std::ptrdiff_t cells = across.cells();
  for (int i = first; i < last; ++i) {
    std::array<float, kGainMoments> m{};
    for (int x = across.begin[at(i)]; x < across.begin[at(i + 1)]; ++x)
      for (std::size_t k = 0; k < m.size(); ++k)
        m[k] += column[k / 3][x - left] * across.weight[at(x)][k % 3];
    for (std::size_t k = 0; k < m.size(); ++k)
      moment[static_cast<std::ptrdiff_t>(k) * cells + i] = m[k];
  }
}

void sum_under_gain(const float* moment, int cells, const GainRows& gain, float* sum) {
  std::fill_n(sum, cells, 0.0f);
  for (int k = 0; k < kGainMoments; ++k, moment += cells) {
    const float* row = gain[static_cast<std::size_t>(k / 3)];
    for (int i = 0; i < cells; ++i)
      sum[i] += moment[i] * row[std::clamp(i + k % 3 - 1, 0, cells - 1)];
  }
}

float light_ratio(float wanted, float found) {
  return std::clamp((wanted + kFloor) / (found + kFloor), 1 / kStep, kStep);
}

}  // namespace pentimento
