#include "core/fluid/conservative/advection/remap_far.h"

#include <algorithm>

#include "core/fluid/conservative/advection/limiter.h"
#include "core/fluid/conservative/tiles/quantum.h"

namespace pentimento::conservative {
namespace {

struct CellImage {
  float begin = 0, end = 0;  // in cells along the line, begin <= end
  bool reversed = false;
};

CellImage image_of(const FarCell& cell, const FarLine& line) {
  const auto first = static_cast<float>(line.before);
  const auto end = static_cast<float>(line.before + line.cells);
  const int at = line.before + cell.at;
  CellImage image;
  image.begin = std::clamp(static_cast<float>(at) + cell.edge_lo, first, end);
  image.end = std::clamp(static_cast<float>(at + 1) + cell.edge_hi, first, end);
  image.reversed = image.end < image.begin;
  if (image.reversed) std::swap(image.begin, image.end);
  return image;
}

// Calls put(cell of the line, share of the amount in it) for all but the last cell the image
// covers, then put_rest(last). The share below t of the profile m + s (t - 1/2) is
// t + (s/m) (t^2 - t) / 2.
template <typename Put, typename PutRest>
void for_parts(const CellImage& image, const FarLine& line, float relative_slope, const Put& put,
               const PutRest& put_rest) {
  const float slope = image.reversed ? -relative_slope : relative_slope;
  const auto share_below = [&](float t) { return t + 0.5f * slope * (t * t - t); };
  const int end = line.before + line.cells;
  const int first = std::min(static_cast<int>(image.begin), end - 1);
  const int last = std::min(static_cast<int>(image.end), end - 1);
  const float extent = image.end - image.begin;
  float below = 0;
  for (int at = first; at < last; ++at) {
    const float t = std::min((static_cast<float>(at + 1) - image.begin) / extent, 1.0f);
    const float next = share_below(t);
    put(at - line.before, next - below);
    below = next;
  }
  put_rest(last - line.before);
}

}  // namespace

float far_slope(const RemapOptions& options, const ThreeRows& value, int i) {
  const float below = value.here[i] - value.before[i];
  const float above = value.after[i] - value.here[i];
  return options.superbee ? limited_superbee(below, above) : limited_mc(below, above);
}

std::vector<FarCell> take_far_cells(const std::vector<int>& far, const float* edge,
                                    const RemapOptions& options, const ThreeRows& value) {
  std::vector<FarCell> taken;
  for (const int i : far) {
    if (value.here[i] == 0) continue;
    taken.push_back({i, 0, edge[i], edge[i + 1], value.here[i], far_slope(options, value, i)});
  }
  return taken;
}

void put_far_cells(const std::vector<FarCell>& far, const FarLine& line, float rounder,
                   const FarTarget& value) {
  for (const FarCell& cell : far) {
    float left = cell.value;
    for_parts(
        image_of(cell, line), line, cell.slope / cell.value,
        [&](int at, float share) {
          const float part = std::clamp(rounded(share * cell.value, rounder), 0.0f, left);
          value(at, cell.lane) += part;
          left -= part;
        },
        [&](int at) { value(at, cell.lane) += left; });
  }
}

void put_far_momentum(const std::vector<FarCell>& far, const std::vector<float>& speed,
                      const FarLine& line, const FarTarget& value, const FarTarget& momentum) {
  for (std::size_t k = 0; k < far.size(); ++k) {
    const FarCell& cell = far[k];
    float left = cell.value;
    const auto put = [&](int at, float part) {
      value(at, cell.lane) += part;
      momentum(at, cell.lane) += part * speed[k];
      left -= part;
    };
    for_parts(
        image_of(cell, line), line, cell.slope / cell.value,
        [&](int at, float share) { put(at, std::clamp(share * cell.value, 0.0f, left)); },
        [&](int at) { put(at, left); });
  }
}

}  // namespace pentimento::conservative
