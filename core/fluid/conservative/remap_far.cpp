#include "core/fluid/conservative/remap_far.h"

#include <algorithm>

#include "core/fluid/conservative/limiter.h"
#include "core/fluid/conservative/quantum.h"

namespace pentimento::conservative {
namespace {

struct Image {
  int lane = 0;              // which line of the block
  float begin = 0, end = 0;  // in cells along the line, begin <= end
  bool reversed = false;
};

Image image_of(const RemapPlan& plan, int index) {
  const int length = plan.cells() / plan.step;
  const int at = index / plan.step;
  const auto cell = static_cast<std::size_t>(index);
  const auto clamped = [&](float x) { return std::clamp(x, 0.0f, static_cast<float>(length)); };
  Image image;
  image.lane = index % plan.step;
  image.begin = clamped(static_cast<float>(at) + plan.edge[cell]);
  image.end =
      clamped(static_cast<float>(at + 1) + plan.edge[cell + static_cast<std::size_t>(plan.step)]);
  image.reversed = image.end < image.begin;
  if (image.reversed) std::swap(image.begin, image.end);
  return image;
}

// Calls put(cell of the line, share of the amount in it) for all but the last cell the image
// covers, then put_rest(last). The share below t of the profile m + s (t - 1/2) is
// t + (s/m) (t^2 - t) / 2.
template <typename Put, typename PutRest>
void for_parts(const Image& image, int length, float relative_slope, const Put& put,
               const PutRest& put_rest) {
  const float slope = image.reversed ? -relative_slope : relative_slope;
  const auto share_below = [&](float t) { return t + 0.5f * slope * (t * t - t); };
  const int first = std::min(static_cast<int>(image.begin), length - 1);
  const int last = std::min(static_cast<int>(image.end), length - 1);
  const float extent = image.end - image.begin;
  float below = 0;
  for (int at = first; at < last; ++at) {
    const float t = std::min((static_cast<float>(at + 1) - image.begin) / extent, 1.0f);
    const float next = share_below(t);
    put(at, next - below);
    below = next;
  }
  put_rest(last);
}

}  // namespace

std::vector<FarCell> take_far_cells(const RemapPlan& plan, const RemapOptions& options,
                                    const float* value) {
  std::vector<FarCell> far;
  for (const int i : plan.far) {
    if (value[i] == 0) continue;
    const float below = value[i] - value[i - plan.step];
    const float above = value[i + plan.step] - value[i];
    const float slope =
        options.superbee ? limited_superbee(below, above) : limited_mc(below, above);
    far.push_back({i, value[i], slope});
  }
  return far;
}

void put_far_cells(const RemapPlan& plan, const RemapOptions& options,
                   const std::vector<FarCell>& far, float* value) {
  const int length = plan.cells() / plan.step;
  for (const FarCell& cell : far) {
    const Image image = image_of(plan, cell.index);
    float left = cell.value;
    const auto target = [&](int at) -> float& { return value[at * plan.step + image.lane]; };
    for_parts(
        image, length, cell.slope / cell.value,
        [&](int at, float share) {
          const float part = std::clamp(rounded(share * cell.value, options.rounder), 0.0f, left);
          target(at) += part;
          left -= part;
        },
        [&](int at) { target(at) += left; });
  }
}

void put_far_momentum(const RemapPlan& plan, const std::vector<FarCell>& far,
                      const std::vector<float>& speed, float* value, float* momentum) {
  const int length = plan.cells() / plan.step;
  for (std::size_t k = 0; k < far.size(); ++k) {
    const Image image = image_of(plan, far[k].index);
    float left = far[k].value;
    const auto put = [&](int at, float part) {
      value[at * plan.step + image.lane] += part;
      momentum[at * plan.step + image.lane] += part * speed[k];
      left -= part;
    };
    for_parts(
        image, length, far[k].slope / far[k].value,
        [&](int at, float share) { put(at, std::clamp(share * far[k].value, 0.0f, left)); },
        [&](int at) { put(at, left); });
  }
}

}  // namespace pentimento::conservative
