#include "core/detail/flow/relief_bands.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/kernel.h"
#include "core/base/transpose.h"

namespace pentimento {
namespace {
constexpr float kTwoPi = 6.2831853f;
constexpr float kWavelength = 1.5f;  // of a band, in widths of its wider triangle
constexpr float kThinnestFilm_m = 1e-6f;
}  // namespace

float standing_amplitude_m(const ReliefStrength& strength, float wavelength_m, float film_m) {
  const float length = wavelength_m / kTwoPi;  // 1 / q
  return strength.yield_per_tension_per_m * length * length *
         std::max(1.0f, length / std::max(film_m, kThinnestFilm_m));
}

namespace {

/// Divides sums of `width` values; by a power of two as a product, which has the same bits.
struct WidthDivider {
  explicit WidthDivider(int of) : width(of), share(1 / width), multiplies((of & (of - 1)) == 0) {}
  float mean(double sum) const {
    return static_cast<float>(multiplies ? sum * share : sum / width);
  }
  double width, share;
  bool multiplies;
};

// Rows that are averaged along together, turned so that a vector has one cell of each: each sum
// waits for the one before it.
constexpr int kTurned = 16;

/// Cells of kTurned rows as columns: cell i of row r is value[i * kTurned + r].
using TurnedRows = std::vector<float>;

/// Means over cells i - before .. i - before + width - 1 of each row of `n` cells.
PENTIMENTO_KERNEL
void mean_turned(const WidthDivider& given, const float* in, int n, int width, int before,
                 float* __restrict out) {
  const WidthDivider divider = given;
  const auto cells_at = [&](int i) {
    return in + std::ptrdiff_t{kTurned} * std::clamp(i, 0, n - 1);
  };
  double sum[kTurned] = {};
  for (int i = -before; i < width - before; ++i) {
    const float* cells = cells_at(i);
    for (int r = 0; r < kTurned; ++r) sum[r] += static_cast<double>(cells[r]);
  }
  for (int i = 0; i < n; ++i) {
    const float* enters = cells_at(i - before + width);
    const float* leaves = cells_at(i - before);
    for (int r = 0; r < kTurned; ++r) {
      out[i * kTurned + r] = divider.mean(sum[r]);
      sum[r] += static_cast<double>(enters[r]) - static_cast<double>(leaves[r]);
    }
  }
}

/// The means of the means along each row, which lean by `first` and by `second`.
void mean_along_twice(const Field<float>& in, int width, int first, int second, Field<float>& out) {
  const int n = in.width();
  const WidthDivider divider(width);
  TurnedRows rows(static_cast<std::size_t>(n) * kTurned), means(rows.size());
  for (int y = 0; y < in.height(); y += kTurned) {
    const int count = std::min(kTurned, in.height() - y);
    transpose({in.row(y), in.view().stride()}, count, n, {rows.data(), kTurned});
    mean_turned(divider, rows.data(), n, width, first, means.data());
    mean_turned(divider, means.data(), n, width, second, rows.data());
    transpose({rows.data(), kTurned}, n, count, {out.row(y), out.view().stride()});
  }
}

PENTIMENTO_KERNEL
void add_row_to_sums(const float* values, int n, double* __restrict sum) {
  for (int x = 0; x < n; ++x) sum[x] += static_cast<double>(values[x]);
}

/// Writes the means of sums, and goes on to the next row's.
PENTIMENTO_KERNEL
void write_means(const WidthDivider& given, const float* enters, const float* leaves, int n,
                 double* __restrict sum, float* __restrict out) {
  const WidthDivider divider = given;
  for (int x = 0; x < n; ++x) {
    out[x] = divider.mean(sum[x]);
    const double more = sum[x] + static_cast<double>(enters[x]);
    sum[x] = more - static_cast<double>(leaves[x]);
  }
}

/// The same down the columns, once.
void mean_down(const Field<float>& in, int width, int before, Field<float>& out) {
  const auto row = [&](int y) { return in.row(std::clamp(y, 0, in.height() - 1)); };
  const WidthDivider divider(width);
  std::vector<double> sum(static_cast<std::size_t>(in.width()));
  for (int y = -before; y < width - before; ++y) add_row_to_sums(row(y), in.width(), sum.data());
  for (int y = 0; y < in.height(); ++y)
    write_means(divider, row(y - before + width), row(y - before), in.width(), sum.data(),
                out.row(y));
}

/// out += l(finer - wider), l of level_bands().
PENTIMENTO_KERNEL
void add_levelled_row(const ReliefStrength& given, float wavelength_m, const float* finer,
                      const float* wider, const float* film_m, int n, float* __restrict out) {
  const ReliefStrength strength = given;
  for (int x = 0; x < n; ++x) {
    const float a = finer[x] - wider[x];
    const float share = a / standing_amplitude_m(strength, wavelength_m, film_m[x]);
    out[x] += a / std::sqrt(1 + share * share);
  }
}
}  // namespace

void triangle_mean(const Field<float>& in, int width, Field<float>& out) {
  // The second mean leans the other way, so that an even width is symmetric too.
  const int first = width / 2, second = width - 1 - first;
  Field<float> between(in.width(), in.height());
  mean_along_twice(in, width, first, second, out);
  mean_down(out, width, first, between);
  mean_down(between, width, second, out);
}

void level_bands(const ReliefStrength& strength, int factor, const Field<float>& film_m,
                 Field<float>& relief_m) {
  const int columns = relief_m.width(), rows = relief_m.height();
  Field<float> wide(columns, rows), narrow(columns, rows), levelled(columns, rows);
  triangle_mean(relief_m, std::max(1, factor / 2), wide);
  for (int y = 0; y < rows; ++y) std::copy_n(wide.row(y), columns, levelled.row(y));
  for (int width = factor / 2; width > 1; width /= 2) {
    const float wavelength_m = kWavelength * static_cast<float>(width) * strength.cell_m;
    if (width / 2 > 1) triangle_mean(relief_m, width / 2, narrow);
    const Field<float>& finer = width / 2 > 1 ? narrow : relief_m;
    for (int y = 0; y < rows; ++y)
      add_levelled_row(strength, wavelength_m, finer.row(y), wide.row(y), film_m.row(y), columns,
                       levelled.row(y));
    swap(wide, narrow);
  }
  swap(relief_m, levelled);
}

}  // namespace pentimento
