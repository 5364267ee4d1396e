#include "core/shading/horizon_row.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/base/kernel.h"

namespace pentimento {

namespace {
constexpr float kLampSize = 0.12f;  // tangent of half the angle that a lamp takes: a soft box
/// Cells that are searched together: their rises stay in the nearest cache.
constexpr std::size_t kLineChunk = 256;
using LineChunk = std::array<float, kLineChunk>;

PENTIMENTO_KERNEL
void slopes(const float* h, std::ptrdiff_t stride, float across, float down, std::size_t n,
            float* right, float* below) {
  PENTIMENTO_INDEPENDENT
  for (std::size_t x = 0; x < n; ++x) {
    right[x] = (h[x + 1] - h[static_cast<std::ptrdiff_t>(x) - 1]) * across;
    below[x] =
        (h[static_cast<std::ptrdiff_t>(x) + stride] - h[static_cast<std::ptrdiff_t>(x) - stride]) *
        down;
  }
}

/// rise = max(rise, (there - here - slope . way) / |way|)
PENTIMENTO_KERNEL
void raise_over_plane(const float* here, const float* there, const float* right, const float* below,
                      float way_x, float way_y, float per_m, std::size_t n, float* rise) {
  PENTIMENTO_INDEPENDENT
  for (std::size_t x = 0; x < n; ++x) {
    const float r = (there[x] - here[x] - (right[x] * way_x + below[x] * way_y)) * per_m;
    rise[x] = r > rise[x] ? r : rise[x];
  }
}

PENTIMENTO_KERNEL
void add_cos2(const float* rise, float share, std::size_t n, float* seen) {
  PENTIMENTO_INDEPENDENT
  for (std::size_t x = 0; x < n; ++x) seen[x] += share / (1.0f + rise[x] * rise[x]);
}

/// rise = max(rise, (between(first, second) - here) / distance)
PENTIMENTO_KERNEL
void raise_between(const float* here, const float* first, const float* second, float share,
                   float per_m, std::size_t n, float* rise) {
  const float rest = 1.0f - share;
  PENTIMENTO_INDEPENDENT
  for (std::size_t x = 0; x < n; ++x) {
    const float r = (first[x] * rest + second[x] * share - here[x]) * per_m;
    rise[x] = r > rise[x] ? r : rise[x];
  }
}

float share_seen(float elevation, float rise) {
  return std::clamp(0.5f + 0.5f * (elevation - rise) / kLampSize, 0.0f, 1.0f);
}

/// The way to a lamp over the cells.
struct LampLine {
  bool hidden_by_nothing;  // below the canvas, or straight above
  bool across;             // the longer axis is that of the columns
  float step_x, step_y;    // cells, 1 along the longer axis
  float length_m;          // of a step
  float elevation;         // its tangent
};

LampLine line_to(const std::array<float, 3>& direction, float dx_m, float dy_m) {
  const float x = direction[0] / dx_m, y = -direction[1] / dy_m;  // cells, rows down
  const float longer = std::max(std::abs(x), std::abs(y));
  const float level = std::sqrt(direction[0] * direction[0] + direction[1] * direction[1]);
  LampLine line{};
  line.hidden_by_nothing = direction[2] <= 0 || level < 1e-3f * direction[2];
  if (line.hidden_by_nothing) return line;
  line.across = std::abs(x) >= std::abs(y);
  line.step_x = line.across ? (x > 0 ? 1.0f : -1.0f) : x / longer;
  line.step_y = line.across ? y / longer : (y > 0 ? 1.0f : -1.0f);
  const float run_x = line.step_x * dx_m, run_y = line.step_y * dy_m;
  line.length_m = std::sqrt(run_x * run_x + run_y * run_y);
  line.elevation = direction[2] / level;
  return line;
}

/// The two cells beside a line at `step`, as offsets, and how much of the second.
struct Beside {
  std::ptrdiff_t first, second;
  float share;
};
Beside beside(const LampLine& line, float step, std::ptrdiff_t stride) {
  const float x = line.step_x * step, y = line.step_y * step;
  const float before_x = std::floor(x), before_y = std::floor(y);
  const auto first =
      static_cast<std::ptrdiff_t>(before_x) + static_cast<std::ptrdiff_t>(before_y) * stride;
  return {first, first + (line.across ? stride : 1), line.across ? y - before_y : x - before_x};
}

/// The lines of a chunk of cells to a near lamp, as LampLine has them.
struct NearLines {
  LineChunk step_x, step_y, per_m, elevation;
  std::array<std::int32_t, kLineChunk> beside;  // from the first cell beside the line to the second
  LineChunk open;                               // 1 where nothing can hide it, else 0
};

/// `up_m`: distance from the row to the lamp, upwards in the picture's plane; `column`: of the
/// first cell.
PENTIMENTO_KERNEL
void aim(const HeightRows& rows, const NearLamp& lamp, int column, float up_m, std::size_t n,
         NearLines& out) {
  const float lamp_x = lamp.position_m[0] + lamp.half_m[0], lamp_z = lamp.position_m[2];
  const float dx = rows.dx_m, dy = rows.dy_m, per_relief = lamp.per_relief;
  const float y = -up_m / dy, across_y = std::abs(y);
  const auto stride = static_cast<std::int32_t>(rows.stride);
  const float* h = rows.cell;
  float *step_x = out.step_x.data(), *step_y = out.step_y.data(), *per_m = out.per_m.data();
  float *elevation = out.elevation.data(), *open = out.open.data();
  std::int32_t* beside = out.beside.data();
  PENTIMENTO_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i) {
    const float to_x = lamp_x - (static_cast<float>(column + static_cast<int>(i)) + 0.5f) * dx;
    const float to_z = lamp_z - h[i] * per_relief;
    const float x = to_x / dx, across_x = std::abs(x);
    const float longer = std::max(std::max(across_x, across_y), 1e-30f);
    step_x[i] = x / longer;
    step_y[i] = y / longer;
    const float run_x = step_x[i] * dx, run_y = step_y[i] * dy;
    per_m[i] = 1 / std::sqrt(std::max(run_x * run_x + run_y * run_y, 1e-30f));
    const float level = std::sqrt(to_x * to_x + up_m * up_m);
    elevation[i] = to_z / std::max(level, 1e-30f);
    open[i] = std::max(to_z <= 0 ? 1.0f : 0.0f, level < 1e-3f * to_z ? 1.0f : 0.0f);
    beside[i] = across_x >= across_y ? stride : 1;
  }
}

/// rise = max(rise, (between the two cells beside the line at `step` - here) / distance)
PENTIMENTO_KERNEL
void raise_towards(const HeightRows& rows, const NearLines& lines, float step, std::size_t n,
                   float* rise) {
  const float per_step = 1 / step;
  const auto stride = static_cast<std::int32_t>(rows.stride);
  const float* h = rows.cell;
  const float *step_x = lines.step_x.data(), *step_y = lines.step_y.data();
  const float* per_m = lines.per_m.data();
  const std::int32_t* beside = lines.beside.data();
  PENTIMENTO_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i) {
    const float x = step_x[i] * step, y = step_y[i] * step;
    // Downwards: the cast cuts towards zero.
    const auto cut_x = static_cast<std::int32_t>(x), cut_y = static_cast<std::int32_t>(y);
    const std::int32_t left = cut_x - (x < static_cast<float>(cut_x) ? 1 : 0);
    const std::int32_t above = cut_y - (y < static_cast<float>(cut_y) ? 1 : 0);
    const float right_of = x - static_cast<float>(left), below = y - static_cast<float>(above);
    const float share = beside[i] == 1 ? right_of : below;
    const std::int32_t first = static_cast<std::int32_t>(i) + left + above * stride;
    const float height = h[first] * (1 - share) + h[first + beside[i]] * share;
    const float r = (height - h[i]) * (per_m[i] * per_step);
    rise[i] = r > rise[i] ? r : rise[i];
  }
}

PENTIMENTO_KERNEL
void share_of_near(const NearLines& lines, const float* rise, std::size_t n, float* seen) {
  const float *elevation = lines.elevation.data(), *open = lines.open.data();
  PENTIMENTO_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i) {
    const float share = 0.5f + 0.5f / kLampSize * (elevation[i] - rise[i]);
    seen[i] = std::max(std::max(std::min(share, 1.0f), 0.0f), open[i]);
  }
}
}  // namespace

void sky_seen_row(const HeightRows& rows, const HorizonLines& lines, std::span<float> seen) {
  const std::size_t steps = lines.sky.size() / kSkyDirections;
  LineChunk right, below, rise;
  for (std::size_t x0 = 0; x0 < seen.size(); x0 += kLineChunk) {
    const std::size_t n = std::min(kLineChunk, seen.size() - x0);
    const float* here = rows.cell + x0;
    float* out = seen.data() + x0;
    slopes(here, rows.stride, 0.5f / rows.dx_m, 0.5f / rows.dy_m, n, right.data(), below.data());
    std::fill_n(out, n, 0.0f);
    for (std::size_t d = 0; d < kSkyDirections; ++d) {
      std::fill_n(rise.data(), n, 0.0f);
      for (std::size_t i = d * steps; i < (d + 1) * steps; ++i) {
        const auto& [x, y, per_m] = lines.sky[i];
        const float* there =
            here + static_cast<std::ptrdiff_t>(x) + static_cast<std::ptrdiff_t>(y) * rows.stride;
        raise_over_plane(here, there, right.data(), below.data(), x * rows.dx_m, y * rows.dy_m,
                         per_m, n, rise.data());
      }
      add_cos2(rise.data(), 1.0f / kSkyDirections, n, out);
    }
  }
}

void lamp_seen_row(const HeightRows& rows, const HorizonLines& lines,
                   const std::array<float, 3>& direction, std::span<float> seen) {
  const LampLine line = line_to(direction, rows.dx_m, rows.dy_m);
  if (line.hidden_by_nothing) return std::fill(seen.begin(), seen.end(), 1.0f);
  LineChunk rise;
  for (std::size_t x0 = 0; x0 < seen.size(); x0 += kLineChunk) {
    const std::size_t n = std::min(kLineChunk, seen.size() - x0);
    const float* here = rows.cell + x0;
    std::fill_n(rise.data(), n, 0.0f);
    for (const float step : lines.shadow) {
      const Beside at = beside(line, step, rows.stride);
      raise_between(here, here + at.first, here + at.second, at.share, 1 / (step * line.length_m),
                    n, rise.data());
    }
    for (std::size_t x = 0; x < n; ++x) seen[x0 + x] = share_seen(line.elevation, rise[x]);
  }
}

void near_lamp_seen_row(const HeightRows& rows, const HorizonLines& lines, const NearLamp& lamp,
                        std::span<float> seen) {
  const float down = (static_cast<float>(lamp.row) + 0.5f) * rows.dy_m - lamp.half_m[1];
  NearLines near;
  LineChunk rise;
  for (std::size_t x0 = 0; x0 < seen.size(); x0 += kLineChunk) {
    const std::size_t n = std::min(kLineChunk, seen.size() - x0);
    const HeightRows here = {rows.cell + x0, rows.stride, rows.dx_m, rows.dy_m};
    aim(here, lamp, lamp.column + static_cast<int>(x0), lamp.position_m[1] + down, n, near);
    std::fill_n(rise.data(), n, 0.0f);
    for (const float step : lines.shadow) raise_towards(here, near, step, n, rise.data());
    share_of_near(near, rise.data(), n, seen.data() + x0);
  }
}

}  // namespace pentimento
