#include "core/detail/flow/relief_bands.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace pentimento {
namespace {
constexpr float kTwoPi = 6.2831853f;
constexpr float kWavelength = 1.5f;  // of a band, in widths of its wider triangle
constexpr float kThinnestFilm_m = 1e-6f;

/// Mean over cells i - before .. i - before + width - 1 of a row.
void mean_along(const float* in, int n, int width, int before, float* out) {
  const auto at = [&](int i) { return static_cast<double>(in[std::clamp(i, 0, n - 1)]); };
  double sum = 0;
  for (int i = -before; i < width - before; ++i) sum += at(i);
  for (int i = 0; i < n; ++i) {
    out[i] = static_cast<float>(sum / width);
    sum += at(i - before + width) - at(i - before);
  }
}

/// The same down the columns.
void mean_down(const Field<float>& in, int width, int before, Field<float>& out) {
  const auto row = [&](int y) { return in.row(std::clamp(y, 0, in.height() - 1)); };
  std::vector<double> sum(static_cast<std::size_t>(in.width()));
  const auto add = [&](int y, double sign) {
    const float* values = row(y);
    for (std::size_t x = 0; x < sum.size(); ++x) sum[x] += sign * static_cast<double>(values[x]);
  };
  for (int y = -before; y < width - before; ++y) add(y, 1);
  for (int y = 0; y < in.height(); ++y) {
    float* to = out.row(y);
    for (std::size_t x = 0; x < sum.size(); ++x) to[x] = static_cast<float>(sum[x] / width);
    add(y - before + width, 1);
    add(y - before, -1);
  }
}
}  // namespace

float standing_amplitude_m(const ReliefStrength& strength, float wavelength_m, float film_m) {
  const float length = wavelength_m / kTwoPi;  // 1 / q
  return strength.yield_per_tension_per_m * length * length *
         std::max(1.0f, length / std::max(film_m, kThinnestFilm_m));
}

void triangle_mean(const Field<float>& in, int width, Field<float>& out) {
  // The second mean leans the other way, so that an even width is symmetric too.
  const int first = width / 2, second = width - 1 - first;
  Field<float> between(in.width(), in.height());
  for (int y = 0; y < in.height(); ++y) {
    mean_along(in.row(y), in.width(), width, first, between.row(y));
    mean_along(between.row(y), in.width(), width, second, out.row(y));
  }
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
    for (int y = 0; y < rows; ++y) {
      const float *in = finer.row(y), *below = wide.row(y), *film = film_m.row(y);
      float* out = levelled.row(y);
      for (int x = 0; x < columns; ++x) {
        const float a = in[x] - below[x];
        const float share = a / standing_amplitude_m(strength, wavelength_m, film[x]);
        out[x] += a / std::sqrt(1 + share * share);
      }
    }
    swap(wide, narrow);
  }
  swap(relief_m, levelled);
}

}  // namespace pentimento
