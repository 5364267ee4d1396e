#include "core/optics/gloss_table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "core/base/check.h"
#include "core/base/kernel.h"
#include "core/base/row_exp.h"
#include "core/optics/irradiance.h"
#include "core/optics/microfacet.h"

namespace pentimento {
namespace {
constexpr float kSteepest = 0.98f;  // sine of a normal's slope
constexpr double kFinest = 0.4;     // pixels that are halved no more, in roughnesses
constexpr double kCoarsest = 1;     // pixels that a lobe is still summed over
constexpr double kWidest = 4;       // of facets' slopes, in roughnesses
/// Exponent of the least weight. Without this limit, products become denormal, which is slow.
constexpr float kFaintest = -60;
/// Sums are kept this many side by side: their order is the same on every machine.
constexpr std::size_t kLanes = 16;

/// A panorama as rows of what its pixels contribute.
struct Sources {
  int width = 0, height = 0;
  std::vector<float> x, y, z;           // direction
  std::vector<float> per_facet;         // 1 / (2 v.h)
  std::vector<float> weight;            // solid angle times Fresnel's share
  std::array<std::vector<float>, 3> L;  // radiance

  double texel_rad() const {
    return std::max(2 * std::numbers::pi / width, std::numbers::pi / height);
  }
};

Sources sources_of(const std::array<Field<float>, 3>& rgb, double index) {
  Sources out;
  out.width = rgb[0].width();
  out.height = rgb[0].height();
  for (int row = 0; row < out.height; ++row) {
    const double area = 2 * std::numbers::pi / out.width *
                        (std::cos(std::numbers::pi * row / out.height) -
                         std::cos(std::numbers::pi * (row + 1) / out.height));
    for (int column = 0; column < out.width; ++column) {
      const auto d = panorama_direction((column + 0.5) / out.width, (row + 0.5) / out.height);
      const double v_h = std::sqrt(std::max(0.0, (1 + d[2]) / 2));
      const bool seen = v_h > 1e-3;  // straight from behind the canvas
      out.x.push_back(static_cast<float>(d[0]));
      out.y.push_back(static_cast<float>(d[1]));
      out.z.push_back(static_cast<float>(d[2]));
      out.per_facet.push_back(seen ? static_cast<float>(0.5 / v_h) : 0);
      out.weight.push_back(seen ? static_cast<float>(area * fresnel(v_h, index)) : 0);
      for (std::size_t c = 0; c < 3; ++c) out.L[c].push_back(rgb[c](column, row));
    }
  }
  return out;
}

std::array<Field<float>, 3> halved(const std::array<Field<float>, 3>& rgb) {
  std::array<Field<float>, 3> out;
  for (std::size_t c = 0; c < 3; ++c) {
    out[c] = Field<float>(rgb[c].width() / 2, rgb[c].height() / 2);
    for (int y = 0; y < out[c].height(); ++y) {
      const float *a = rgb[c].row(2 * y), *b = rgb[c].row(2 * y + 1);
      for (int x = 0; x < out[c].width(); ++x)
        out[c](x, y) = 0.25f * ((a[2 * x] + a[2 * x + 1]) + (b[2 * x] + b[2 * x + 1]));
    }
  }
  return out;
}

/// The panorama and its halves, finest first.
std::vector<Sources> all_sources(const Panorama& probe, double index) {
  std::array<Field<float>, 3> rgb;
  for (std::size_t c = 0; c < 3; ++c) {
    rgb[c] = Field<float>(probe[c].width(), probe[c].height());
    for (int y = 0; y < probe[c].height(); ++y)
      std::copy_n(probe[c].row(y), probe[c].width(), rgb[c].row(y));
  }
  std::vector<Sources> out;
  out.push_back(sources_of(rgb, index));
  while (out.back().width % 2 == 0 && out.back().height % 2 == 0 && out.back().width > 16) {
    rgb = halved(rgb);
    out.push_back(sources_of(rgb, index));
  }
  return out;
}

struct Lobe {
  float n_x, n_y, n_z;
  float per_a2;
};

/// Lobe times n.l of pixels [first, first + n), but for constant factors.
PENTIMENTO_KERNEL
void weigh(const Lobe& lobe, const float* x, const float* y, const float* z, const float* per_facet,
           const float* weight, std::size_t n, float* out) {
  const float n_x = lobe.n_x, n_y = lobe.n_y, n_z = lobe.n_z, per_a2 = lobe.per_a2;
  PENTIMENTO_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i) {
    const float n_l = n_x * x[i] + n_y * y[i] + n_z * z[i];
    const float n_h = (n_l + n_z) * per_facet[i];
    const float per_c2 = 1 / std::max(n_h * n_h, 1e-6f);
    const float density = row_exp(std::max((1 - per_c2) * per_a2, kFaintest)) * (per_c2 * per_c2);
    // Nothing from below the horizon.
    const float flatter = std::max(std::min(n_z, n_l), 0.0f);
    const float grooves = std::min(1.0f, 4 * n_h * flatter * per_facet[i]);
    out[i] = weight[i] * (density * grooves);
  }
}

/// Sums side by side, red, green, blue and the weights themselves.
using Lanes = std::array<float, kLanes>;
struct Sums {
  Lanes red{}, green{}, blue{}, weight{};
};

PENTIMENTO_KERNEL
void add_products(const float* weight, const float* light, std::size_t n, float* lanes) {
  std::size_t i = 0;
  for (; i + kLanes <= n; i += kLanes) {
    PENTIMENTO_INDEPENDENT
    for (std::size_t k = 0; k < kLanes; ++k) lanes[k] += weight[i + k] * light[i + k];
  }
  for (std::size_t k = 0; i + k < n; ++k) lanes[k] += weight[i + k] * light[i + k];
}

PENTIMENTO_KERNEL
void add_weights(const float* weight, std::size_t n, float* lanes) {
  std::size_t i = 0;
  for (; i + kLanes <= n; i += kLanes) {
    PENTIMENTO_INDEPENDENT
    for (std::size_t k = 0; k < kLanes; ++k) lanes[k] += weight[i + k];
  }
  for (std::size_t k = 0; i + k < n; ++k) lanes[k] += weight[i + k];
}

double total(const Lanes& lanes) {
  double sum = 0;
  for (const float v : lanes) sum += static_cast<double>(v);
  return sum;
}

/// Pixels whose direction may lie within `reach_rad` of direction d, as runs of one row each.
struct PixelRange {
  int first_row, rows;
  int first_column, columns;  // may go on past the row's end, round to its beginning
};
PixelRange pixels_near(const Sources& s, const std::array<double, 3>& d, double reach_rad) {
  const double down = std::acos(std::clamp(d[1], -1.0, 1.0));  // from the top
  const double row_rad = std::numbers::pi / s.height, column_rad = 2 * std::numbers::pi / s.width;
  PixelRange out{};
  out.first_row = std::max(0, static_cast<int>((down - reach_rad) / row_rad));
  const int end = std::min(s.height, static_cast<int>((down + reach_rad) / row_rad) + 1);
  out.rows = end - out.first_row;
  out.columns = s.width;
  if (down - reach_rad <= 0 || down + reach_rad >= std::numbers::pi) return out;
  const double level = std::sin(reach_rad) / std::sin(down);
  if (level >= 1) return out;
  const double half = std::asin(level) / column_rad + 1;
  // The middle column is +z, and columns turn towards -x.
  const double middle = (std::atan2(-d[0], d[2]) / (2 * std::numbers::pi) + 0.5) * s.width;
  out.columns = std::min(s.width, static_cast<int>(2 * half) + 1);
  out.first_column = static_cast<int>(std::floor(middle - half)) % s.width;
  if (out.first_column < 0) out.first_column += s.width;
  return out;
}

/// Interpolates between the four nearest pixels: what a perfect mirror shows.
std::array<float, 3> radiance(const Sources& s, const std::array<double, 3>& d) {
  const double u = (std::atan2(-d[0], d[2]) / (2 * std::numbers::pi) + 0.5) * s.width - 0.5;
  const double v = std::acos(std::clamp(d[1], -1.0, 1.0)) / std::numbers::pi * s.height - 0.5;
  const int x = static_cast<int>(std::floor(u)), y = static_cast<int>(std::floor(v));
  const auto a = static_cast<float>(u - x), b = static_cast<float>(v - y);
  const auto at = [&](std::size_t c, int column, int row) {
    column = (column + s.width) % s.width;
    row = std::clamp(row, 0, s.height - 1);
    return s.L[c][static_cast<std::size_t>(row) * static_cast<std::size_t>(s.width) +
                  static_cast<std::size_t>(column)];
  };
  std::array<float, 3> out{};
  for (std::size_t c = 0; c < 3; ++c) {
    out[c] = (at(c, x, y) * (1 - a) + at(c, x + 1, y) * a) * (1 - b) +
             (at(c, x, y + 1) * (1 - a) + at(c, x + 1, y + 1) * a) * b;
  }
  return out;
}

/// One normal at one roughness.
std::array<float, 3> shown(const Sources& s, const std::array<float, 3>& n, double a,
                           std::vector<float>& weights) {
  const double z = static_cast<double>(n[2]);
  const std::array<double, 3> mirrored = {2 * z * static_cast<double>(n[0]),
                                          2 * z * static_cast<double>(n[1]), 2 * z * z - 1};
  if (s.texel_rad() > kCoarsest * a) return radiance(s, mirrored);
  const Lobe lobe{n[0], n[1], n[2], static_cast<float>(1 / (a * a))};
  const PixelRange near = pixels_near(s, mirrored, 2 * std::atan(kWidest * a) + s.texel_rad());
  Sums sums;
  weights.resize(static_cast<std::size_t>(s.width));
  const auto run = [&](std::size_t at, std::size_t count) {
    weigh(lobe, &s.x[at], &s.y[at], &s.z[at], &s.per_facet[at], &s.weight[at], count,
          weights.data());
    add_weights(weights.data(), count, sums.weight.data());
    add_products(weights.data(), &s.L[0][at], count, sums.red.data());
    add_products(weights.data(), &s.L[1][at], count, sums.green.data());
    add_products(weights.data(), &s.L[2][at], count, sums.blue.data());
  };
  for (int row = near.first_row; row < near.first_row + near.rows; ++row) {
    const std::size_t begin = static_cast<std::size_t>(row) * static_cast<std::size_t>(s.width);
    const int straight = std::min(near.columns, s.width - near.first_column);
    run(begin + static_cast<std::size_t>(near.first_column), static_cast<std::size_t>(straight));
    if (near.columns > straight) run(begin, static_cast<std::size_t>(near.columns - straight));
  }
  const double weight = total(sums.weight);
  if (!(weight > 0)) return radiance(s, mirrored);
  return {static_cast<float>(total(sums.red) / weight),
          static_cast<float>(total(sums.green) / weight),
          static_cast<float>(total(sums.blue) / weight)};
}

/// Normal of texel (i, j); nothing for a texel that no normal needs.
std::optional<std::array<float, 3>> normal_at(int i, int j) {
  float x = static_cast<float>(2 * i + 1) / GlossTable::kSide - 1;
  float y = static_cast<float>(2 * j + 1) / GlossTable::kSide - 1;
  const float sine = std::sqrt(x * x + y * y);
  if (sine > 1 + 4.0f / GlossTable::kSide) return std::nullopt;
  if (sine > kSteepest) {
    x *= kSteepest / sine;
    y *= kSteepest / sine;
  }
  return std::array<float, 3>{x, y, std::sqrt(1 - x * x - y * y)};
}

}  // namespace

GlossTable make_gloss_table(const Panorama& probe, const GlossSurface& surface,
                            const Threads& threads) {
  PENTIMENTO_CHECK(probe[0].width() > 0 && probe[0].height() > 0);
  const std::vector<Sources> all =
      all_sources(probe, static_cast<double>(surface.refractive_index));
  constexpr int kSide = GlossTable::kSide, kLevels = GlossTable::kLevels;
  const double dry = static_cast<double>(surface.roughness_dry);
  const double wet = static_cast<double>(surface.roughness_wet);
  GlossTable table;
  table.rgb.resize(std::size_t{3} * kSide * kSide * kLevels);
  threads.for_ranges(0, kSide * kLevels, 1, [&](int begin, int end) {
    std::vector<float> weights;
    for (int line = begin; line < end; ++line) {
      const int level = line / kSide;
      const double a = dry + (wet - dry) * level / (kLevels - 1);
      const Sources* source = &all.front();
      for (const Sources& s : all) {
        if (s.texel_rad() <= kFinest * a) source = &s;
      }
      float* out = table.rgb.data() + std::ptrdiff_t{3} * kSide * line;
      for (int i = 0; i < kSide; ++i, out += 3) {
        const auto normal = normal_at(i, line % kSide);
        if (!normal) continue;
        const auto light = shown(*source, *normal, a, weights);
        std::copy(light.begin(), light.end(), out);
      }
    }
  });
  return table;
}

}  // namespace pentimento
