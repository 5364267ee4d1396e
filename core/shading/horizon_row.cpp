#include "core/shading/horizon_row.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/fluid/conservative/kernel.h"

namespace pentimento {

namespace {
constexpr float kLampSize = 0.12f;  // tangent of half the angle that a lamp takes: a soft box
/// Cells that are searched together: their rises stay in the nearest cache.
constexpr std::size_t kChunk = 256;
using Chunk = std::array<float, kChunk>;

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
}  // namespace

void sky_seen_row(const HeightRows& rows, const HorizonLines& lines, std::span<float> seen) {
  const std::size_t steps = lines.sky.size() / kSkyDirections;
  Chunk right, below, rise;
  for (std::size_t x0 = 0; x0 < seen.size(); x0 += kChunk) {
    const std::size_t n = std::min(kChunk, seen.size() - x0);
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
  Chunk rise;
  for (std::size_t x0 = 0; x0 < seen.size(); x0 += kChunk) {
    const std::size_t n = std::min(kChunk, seen.size() - x0);
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
  const auto& [lamp_x, lamp_y, lamp_z] = lamp.position_m;
  const float down = (static_cast<float>(lamp.row) + 0.5f) * rows.dy_m - lamp.half_m[1];
  for (std::size_t x = 0; x < seen.size(); ++x) {
    const float* here = rows.cell + x;
    const float column = static_cast<float>(lamp.column + static_cast<int>(x));
    const float right = (column + 0.5f) * rows.dx_m - lamp.half_m[0];
    const std::array<float, 3> to = {lamp_x - right, lamp_y + down,
                                     lamp_z - *here * lamp.per_relief};
    const LampLine line = line_to(to, rows.dx_m, rows.dy_m);
    float rise = 0;
    for (std::size_t i = 0; !line.hidden_by_nothing && i < lines.shadow.size(); ++i) {
      const float step = lines.shadow[i];
      const Beside at = beside(line, step, rows.stride);
      const float h = here[at.first] * (1 - at.share) + here[at.second] * at.share;
      rise = std::max(rise, (h - *here) / (step * line.length_m));
    }
    seen[x] = line.hidden_by_nothing ? 1.0f : share_seen(line.elevation, rise);
  }
}

}  // namespace pentimento
