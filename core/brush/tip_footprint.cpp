#include "core/brush/tip_footprint.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <tuple>
#include <utility>
#include <vector>

#include "core/base/four.h"
#include "core/base/kernel.h"

namespace pentimento {

namespace {
constexpr int kMostFootprints = 8;
constexpr float kTexelsPerCell = 3;
constexpr int kRim = 2;  // zeros that positions outside are led to

PENTIMENTO_KERNEL
void blend_row(const float* a, const float* b, float frac, int n, float* __restrict out) {
  for (int i = 0; i < n; ++i) out[i] = a[i] + frac * (b[i] - a[i]);
}

PENTIMENTO_KERNEL
void multiply_row(float by, int n, float* __restrict out) {
  for (int i = 0; i < n; ++i) out[i] *= by;
}

/// out += the mean of four neighbours, weighted.
PENTIMENTO_KERNEL
void add_shifted_row(const float* top, const float* bottom, const float* w, int n,
                     float* __restrict out) {
  const float a = w[0], b = w[1], c = w[2], d = w[3];
  for (int i = 0; i < n; ++i)
    out[i] += (a * top[i] + b * top[i + 1]) + (c * bottom[i] + d * bottom[i + 1]);
}

constexpr int kTogether = 16;  // sums that stay in registers

/// A filter along the rows, where `step` is 1, or across them, where it is the rows' distance.
struct BoxFilter {
  const float* weight;
  int taps;
  std::ptrdiff_t step, in_stride, out_stride;
};

/// out[i] = sum of weight[j] in[i + j step] in each row, in the order of the taps. `n` is at least
/// kTogether.
PENTIMENTO_KERNEL
void filter_rows(const BoxFilter& filter, const float* in, float* __restrict out, int rows, int n) {
  const BoxFilter f = filter;
  for (int y = 0; y < rows; ++y, in += f.in_stride, out += f.out_stride) {
    for (int i = 0; i < n; i += kTogether) {
      // The last sums of a row begin where they all fit; some are found twice.
      const int at = std::min(i, n - kTogether);
      float sum[kTogether] = {};
      for (int j = 0; j < f.taps; ++j)
        for (int k = 0; k < kTogether; ++k) sum[k] += f.weight[j] * in[at + k + j * f.step];
      for (int k = 0; k < kTogether; ++k) out[at + k] = sum[k];
    }
  }
}

/// The share that a box of `width` texels takes of each texel around its middle texel.
void find_box_weights(float width, std::vector<float>& weight) {
  const float half = 0.5f * width;
  const int reach = static_cast<int>(std::ceil(half - 0.5f));
  weight.clear();
  for (int i = -reach; i <= reach; ++i) {
    const float at = std::abs(static_cast<float>(i));
    weight.push_back(std::clamp(half - at + 0.5f, 0.0f, 1.0f) / width);
  }
  if (reach == 0) weight[0] = 1;
}

/// Cuts [begin, end) to about where |at + step i| < half; keeps a few cells more, against rounding.
void cut_to(float at, float step, float half, TipFootprint::CellSpan& cells) {
  if (step < 0) {
    at = -at;
    step = -step;
  }
  const float length = static_cast<float>(cells.end);
  if (step * length < 1e-3f) {  // a row along the tip's other axis
    if (std::abs(at) > half) cells.end = cells.begin;
    return;
  }
  const float begin = std::clamp((-half - at) / step - 2, -1.0f, length);
  const float end = std::clamp((half - at) / step + 3, 0.0f, length);
  cells.begin = std::max(cells.begin, static_cast<int>(begin));
  cells.end = std::min(cells.end, static_cast<int>(end));
}

/// Positions of a row of cells in the map, in texels.
struct MapRow {
  float x0, y0, dx, dy;
  float first_x, last_x, first_y, last_y;  // positions that have a neighbour
};

constexpr int kReadCells = 64;  // that are read together

/// Where cells lie in the map: the texel before each, and how far it lies beyond that texel.
struct MapPlaces {
  std::array<int, kReadCells> texel;
  std::array<float, kReadCells> x, y;
};

PENTIMENTO_KERNEL
void find_places(const MapRow& at, int stride, int first, int n, MapPlaces& places) {
  const MapRow r = at;
  int* __restrict texel = places.texel.data();
  float* __restrict fx = places.x.data();
  float* __restrict fy = places.y.data();
  for (int i = 0; i < n; ++i) {
    const float x = r.x0 + r.dx * static_cast<float>(first + i);
    const float y = r.y0 + r.dy * static_cast<float>(first + i);
    const float cx = std::min(std::max(x, r.first_x), r.last_x);
    const float cy = std::min(std::max(y, r.first_y), r.last_y);
    const int ix = static_cast<int>(cx), iy = static_cast<int>(cy);
    texel[i] = iy * stride + ix;
    fx[i] = cx - static_cast<float>(ix);
    fy[i] = cy - static_cast<float>(iy);
  }
}

/// The values at the texels of four cells, and at the texels right of those.
struct TexelPairs {
  Four left, right;

  TexelPairs(const float* map, const int* texel) {
    const Four ab = two_pairs(map + texel[0], map + texel[1]);
    const Four cd = two_pairs(map + texel[2], map + texel[3]);
    left = __builtin_shufflevector(ab, cd, 0, 2, 4, 6);
    right = __builtin_shufflevector(ab, cd, 1, 3, 5, 7);
  }

 private:
  static Four two_pairs(const float* a, const float* b) {
    // A pair is carried as a double, which no instruction computes with.
    using Pairs = double __attribute__((vector_size(16)));
    double first, second;
    std::memcpy(&first, a, sizeof(first));
    std::memcpy(&second, b, sizeof(second));
    const Pairs pairs = {first, second};
    return std::bit_cast<Four>(pairs);
  }
};

/// The map at `n` places, a multiple of four. Processors look values up one by one, so the two that
/// lie side by side are read as one.
PENTIMENTO_KERNEL
void read_places(const float* map, int stride, const MapPlaces& places, int n,
                 float* __restrict out) {
  for (int i = 0; i < n; i += 4) {
    const int* texel = places.texel.data() + i;
    const TexelPairs above(map, texel), below(map + stride, texel);
    const Four fx = four_at(places.x.data() + i), fy = four_at(places.y.data() + i);
    const Four top = above.left + fx * (above.right - above.left);
    const Four bottom = below.left + fx * (below.right - below.left);
    put_four(top + fy * (bottom - top), out + i);
  }
}

PENTIMENTO_KERNEL
void drop_faint(const float* values, int n, float* __restrict out) {
  constexpr float kFaintest = 1e-3f;
  for (int i = 0; i < n; ++i) out[i] = values[i] < kFaintest ? 0.0f : values[i];
}

void read_row(const float* map, int stride, const MapRow& at, int first, int n, float* out) {
  MapPlaces places;
  std::array<float, kReadCells> values;
  for (int done = 0; done < n; done += kReadCells) {
    const int cells = std::min(kReadCells, n - done), fours = (cells + 3) / 4 * 4;
    find_places(at, stride, first + done, fours, places);
    read_places(map, stride, places, fours, values.data());
    drop_faint(values.data(), cells, out + done);
  }
}

/// Makes a map of at least size x size values and sets a part of it to zero. A larger map stays, so
/// that stamp after stamp needs no new memory.
void make_room(Field<float>& map, int size, const CellBox& part) {
  if (map.width() < size) {
    map = Field<float>(size, size);
    return;
  }
  for (int y = part.y0; y < part.y1; ++y)
    std::fill(map.row(y) + part.x0, map.row(y) + part.x1, 0.0f);
}
}  // namespace

/// The pressed and dried tip, with the margin around it.
void TipFootprint::blend(const TipLevel& level) {
  const int start = margin_ - 1;  // the tip's own maps have a rim of one zero
  const int x0 = std::max(0, part_.x0 - start), x1 = std::min(size_ + 2, part_.x1 - start);
  const int y0 = std::max(0, part_.y0 - start), y1 = std::min(size_ + 2, part_.y1 - start);
  for (int j = y0; j < y1; ++j) {
    float* out = still_.row(start + j) + start + x0;
    blend_row(level.low->padded_row(j) + x0, level.high->padded_row(j) + x0, level.frac, x1 - x0,
              out);
    if (level.supply_low == nullptr) continue;
    const float v = (static_cast<float>(j) - 0.5f) / static_cast<float>(size_) - 0.5f;
    const float few = level.supply_low->at(v);
    multiply_row(few + level.supply_frac * (level.supply_high->at(v) - few), x1 - x0, out);
  }
}

/// map(x) += weight still(x + shift)
void TipFootprint::add_footprint(float u_texels, float v_texels, float weight) {
  const float fu = std::floor(u_texels), fv = std::floor(v_texels);
  const int iu = static_cast<int>(fu), iv = static_cast<int>(fv);
  const float tu = u_texels - fu, tv = v_texels - fv;
  const float w[4] = {weight * (1 - tu) * (1 - tv), weight * tu * (1 - tv), weight * (1 - tu) * tv,
                      weight * tu * tv};
  // What of `still` does not count is zero.
  const int x0 = std::max({kRim, part_.x0, part_.x0 - iu});
  const int x1 = std::min({width_ - kRim, part_.x1, part_.x1 - 1 - iu});
  const int y0 = std::max({kRim, part_.y0, part_.y0 - iv});
  const int y1 = std::min({width_ - kRim, part_.y1, part_.y1 - 1 - iv});
  for (int y = y0; y < y1; ++y)
    add_shifted_row(still_.row(y + iv) + x0 + iu, still_.row(y + iv + 1) + x0 + iu, w, x1 - x0,
                    map_.row(y) + x0);
}

/// map = still * box of `texels`.
void TipFootprint::average(float texels) {
  find_box_weights(texels, box_weight_);
  const int taps = static_cast<int>(box_weight_.size()), reach = taps / 2;
  const std::ptrdiff_t still = still_.view().stride(), map = map_.view().stride();
  PENTIMENTO_CHECK(part_.x1 - part_.x0 - 2 * reach >= kTogether);
  // Along the rows: those around stay zero.
  const int x = part_.x0, y = part_.y0 + reach;
  const int n = part_.x1 - part_.x0, rows = part_.y1 - part_.y0 - 2 * reach;
  filter_rows({box_weight_.data(), taps, 1, still, map}, still_.row(y) + x, map_.row(y) + x + reach,
              rows, n - 2 * reach);
  std::swap(still_, map_);
  // Across them.
  filter_rows({box_weight_.data(), taps, map, map, still}, still_.row(part_.y0) + x,
              map_.row(y) + x, rows, n);
}

/// `u_texels`, `v_texels`: how far the map reaches beyond the tip itself.
void TipFootprint::find_reach(const TipExtent& extent, float u_texels, float v_texels) {
  constexpr float kAround = 2.5f;  // half a texel of the tip's, a bilinear step or two, rounding
  const float half = 0.5f * static_cast<float>(size_);
  half_u_ = half * extent.u + u_texels + kAround;
  half_v_ = half * extent.v + v_texels + kAround;
  // Beyond that the map is zero; the part that counts has a rim of it, and what a box reads.
  const auto part = [&](float half_texels, float texels) {
    const float reach = half_texels + texels + kRim;
    const float least = 0.5f * kTogether + texels + 1;  // for filter_rows()
    const float around = std::max(reach, least);
    return std::pair{std::max(0, static_cast<int>(middle() - around)),
                     std::min(width_, static_cast<int>(middle() + around) + 2)};
  };
  std::tie(part_.x0, part_.x1) = part(half_u_, u_texels);
  std::tie(part_.y0, part_.y1) = part(half_v_, v_texels);
}

void TipFootprint::draw_cells(const StampPlan& plan, float cell_m) {
  const TipLevel level = stamp_tip_level(plan, cell_m / kTexelsPerCell);
  size_ = level.low->size();
  const float texels = cell_m / plan.pose.diameter_m * static_cast<float>(size_);
  const float box = std::sqrt(std::max(0.0f, texels * texels - 3));
  margin_ = kRim + 1 + static_cast<int>(std::ceil(box)) + 1;
  width_ = std::max(size_, kTogether) + 2 * margin_;
  find_reach(plan.extent, box, box);
  make_room(still_, width_, part_);
  make_room(map_, width_, part_);
  blend(level);
  if (box > 0) {
    average(box);
  } else {
    std::swap(still_, map_);
  }
}

void TipFootprint::draw_swept(const StampPlan& plan, float cell_m) {
  const TipLevel level = stamp_tip_level(plan, cell_m);
  size_ = level.low->size();
  const float travel_m = plan.stamp.travel_m;
  const int prints = std::max(
      1, static_cast<int>(std::min(travel_m / cell_m, static_cast<float>(kMostFootprints))));
  const Vec2f way = plan.stamp.direction;
  const float step_m = travel_m / static_cast<float>(prints) * static_cast<float>(size_);
  const float du = step_m * (plan.pose.u_x * way.x + plan.pose.u_y * way.y);
  const float dv = step_m * (plan.pose.v_x * way.x + plan.pose.v_y * way.y);
  const float first = -0.5f * static_cast<float>(prints - 1);
  const float reach = std::max(std::abs(first * du), std::abs(first * dv));
  margin_ = kRim + 2 + static_cast<int>(reach);
  width_ = size_ + 2 * margin_;
  find_reach(plan.extent, std::abs(first * du), std::abs(first * dv));
  make_room(still_, width_, part_);
  blend(level);
  if (prints == 1) {
    std::swap(still_, map_);
    return;
  }
  make_room(map_, width_, part_);
  for (int i = 0; i < prints; ++i) {
    const float at = first + static_cast<float>(i);
    add_footprint(at * du, at * dv, 1 / static_cast<float>(prints));
  }
}

TipFootprint::CellSpan TipFootprint::touched_span(const TipRow& tip, int first, int last) const {
  const float size = static_cast<float>(size_);
  CellSpan cells{first, last};
  cut_to(tip.u0 * size, tip.du * size, half_u_, cells);
  cut_to(tip.v0 * size, tip.dv * size, half_v_, cells);
  cells.end = std::max(cells.begin, cells.end);
  return cells;
}

void TipFootprint::row(const TipRow& tip, int first, std::span<float> out) const {
  const float size = static_cast<float>(size_);
  const float middle = this->middle();
  read_row(map_.row(0), static_cast<int>(map_.view().stride()),
           {tip.u0 * size + middle, tip.v0 * size + middle, tip.du * size, tip.dv * size,
            static_cast<float>(part_.x0), static_cast<float>(part_.x1 - 2),
            static_cast<float>(part_.y0), static_cast<float>(part_.y1 - 2)},
           first, static_cast<int>(out.size()), out.data());
}

}  // namespace pentimento
