#include "core/brush/reservoir.h"

#include <algorithm>

#include "core/base/four.h"
#include "core/base/kernel.h"

namespace pentimento {

namespace {
constexpr int kPadding = 4;       // floats: a texel is whole vectors
constexpr float kTrace = 1e-20f;  // less is nothing: subnormal numbers are slow

/// The first of the four texels around each cell, and the weights of the four.
struct CellTexels {
  std::array<int, kSampledCells> texel;
  std::array<std::array<float, kSampledCells>, 4> weight;
};

/// Finds the same as sample() does for a cell.
PENTIMENTO_KERNEL
void find_texels(const TipRow& given, int first, int n, CellTexels& out) {
  const TipRow tip = given;  // nobody else's: what is stored below does not change it
  int* __restrict texel = out.texel.data();
  float* __restrict a = out.weight[0].data();
  float* __restrict b = out.weight[1].data();
  float* __restrict c = out.weight[2].data();
  float* __restrict d = out.weight[3].data();
  for (int cell = 0; cell < n; ++cell) {
    const float u = tip.u(first + cell), v = tip.v(first + cell);
    const float x =
        std::clamp((u + 0.5f) * kReservoirColumns - 0.5f, 0.0f, kReservoirColumns - 1.0f);
    const float y = std::clamp((v + 0.5f) * kReservoirRows - 0.5f, 0.0f, kReservoirRows - 1.0f);
    const int i = std::min(static_cast<int>(x), kReservoirColumns - 2);
    const int j = std::min(static_cast<int>(y), kReservoirRows - 2);
    const float fx = x - static_cast<float>(i), fy = y - static_cast<float>(j);
    texel[cell] = j * kReservoirColumns + i;
    a[cell] = (1 - fx) * (1 - fy);
    b[cell] = fx * (1 - fy);
    c[cell] = (1 - fx) * fy;
    d[cell] = fx * fy;
  }
}

/// PaintLoad::volume_of(), the same sum.
inline float volume_of(const float* paint, const float* weight, int stride) {
  float lane[4] = {0, 0, 0, 0};
  for (int k = 0; k < stride; k += 4)
    for (int i = 0; i < 4; ++i) lane[i] += weight[k + i] * paint[k + i];
  return (lane[0] + lane[1]) + (lane[2] + lane[3]);
}

/// paint += wanted scale - frac paint; traces become 0.
inline void mix(const float* wanted, float scale, float frac, int stride, float* __restrict paint) {
  for (int k = 0; k < stride; k += 4) {
    for (int i = k; i < k + 4; ++i) {
      const float mixed = paint[i] + (wanted[i] * scale - frac * paint[i]);
      paint[i] = mixed < kTrace ? 0 : mixed;
    }
  }
}

/// `kStride`: floats per texel; 0: `given_stride` floats.
template <int kStride>
inline void blend_cells(const float* data, int given_stride, const CellTexels& at, int n,
                        float* out) {
  const int stride = kStride > 0 ? kStride : given_stride;
  for (int cell = 0; cell < n; ++cell, out += stride) {
    const std::size_t i = static_cast<std::size_t>(cell);
    const float* a = data + static_cast<std::ptrdiff_t>(at.texel[i]) * stride;
    const float* c = a + static_cast<std::ptrdiff_t>(kReservoirColumns) * stride;
    blend_texels(a, a + stride, c, c + stride,
                 {at.weight[0][i], at.weight[1][i], at.weight[2][i], at.weight[3][i]}, stride, out);
  }
}

/// Four cells of four components each become four components of four cells each.
inline void write_transposed(const Four (&cell)[4], float* __restrict out) {
  const Four ab_low = __builtin_shufflevector(cell[0], cell[1], 0, 4, 1, 5);
  const Four ab_high = __builtin_shufflevector(cell[0], cell[1], 2, 6, 3, 7);
  const Four cd_low = __builtin_shufflevector(cell[2], cell[3], 0, 4, 1, 5);
  const Four cd_high = __builtin_shufflevector(cell[2], cell[3], 2, 6, 3, 7);
  const Four component[4] = {__builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5),
                             __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7),
                             __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5),
                             __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7)};
  for (int k = 0; k < 4; ++k) put_four(component[k], out + k * kSampledCells);
}

/// Cells side by side that are looked at for lying between the same four texels. On a finer canvas
/// most do.
constexpr int kAlike = 8;

inline bool are_alike(const int* texel) {
  int differing = 0;
  for (int i = 0; i < kAlike; ++i) differing |= texel[i] ^ texel[0];
  return differing == 0;
}

/// blend_texels() for kAlike cells between the same texels, with components apart.
inline void blend_alike(const float* data, int stride, const CellTexels& at, int first,
                        float* __restrict out) {
  const float* a =
      data + static_cast<std::ptrdiff_t>(at.texel[static_cast<std::size_t>(first)]) * stride;
  const float* c = a + static_cast<std::ptrdiff_t>(kReservoirColumns) * stride;
  const float *b = a + stride, *d = c + stride;
  const float *of_a = at.weight[0].data() + first, *of_b = at.weight[1].data() + first;
  const float *of_c = at.weight[2].data() + first, *of_d = at.weight[3].data() + first;
  for (int k = 0; k < stride; ++k) {
    float* to = out + static_cast<std::ptrdiff_t>(k) * kSampledCells + first;
    for (int i = 0; i < kAlike; ++i)
      to[i] = of_a[i] * a[k] + of_b[i] * b[k] + of_c[i] * c[k] + of_d[i] * d[k];
  }
}

/// blend_texels() for cells four by four, with components apart.
PENTIMENTO_KERNEL
void blend_planes(const float* data, int stride, const CellTexels& at, int n,
                  float* __restrict out) {
  for (int first = 0; first < n; first += 4) {
    if (first + kAlike <= n && are_alike(at.texel.data() + first)) {
      blend_alike(data, stride, at, first, out);
      first += kAlike - 4;
      continue;
    }
    for (int k = 0; k < stride; k += 4) {
      Four cell[4];
      for (int j = 0; j < 4; ++j) {
        const std::size_t i = static_cast<std::size_t>(first + j);
        const float* a = data + static_cast<std::ptrdiff_t>(at.texel[i]) * stride + k;
        const float* c = a + static_cast<std::ptrdiff_t>(kReservoirColumns) * stride;
        cell[j] = at.weight[0][i] * four_at(a) + at.weight[1][i] * four_at(a + stride) +
                  at.weight[2][i] * four_at(c) + at.weight[3][i] * four_at(c + stride);
      }
      write_transposed(cell, out + static_cast<std::ptrdiff_t>(k) * kSampledCells + first);
    }
  }
}
}  // namespace

Reservoir::Reservoir(int channels)
    : stride_((1 + channels + kPadding - 1) / kPadding * kPadding),
      data_(static_cast<std::size_t>(stride_) * kReservoirTexels, 0.0f) {}

void Reservoir::fill(const PaintLoad& load) {
  fill_rows(load, 0, kReservoirRows);
  as_loaded_ = true;
  surplus_ = 0;
}

void Reservoir::empty() {
  std::fill(data_.begin(), data_.end(), 0.0f);
  as_loaded_ = false;
}

void Reservoir::restore(Content content) {
  PENTIMENTO_CHECK(content.texels.size() == data_.size());
  as_loaded_ = content.as_loaded;
  density_frac = content.density_frac;
  dry_ahead_frac = content.dry_ahead_frac;
  data_ = std::move(content.texels);
  surplus_ = 0;  // measured anew by the next refill
}

void Reservoir::fill_rows(const PaintLoad& load, int begin, int end) {
  PENTIMENTO_CHECK(static_cast<int>(load.paint.size()) == stride_);
  for (int r = begin; r < end; ++r) {
    for (int c = 0; c < kReservoirColumns; ++c)
      std::copy_n(load.row(r), stride_,
                  data_.data() + static_cast<std::ptrdiff_t>(r * kReservoirColumns + c) * stride_);
  }
}

void Reservoir::sample(float u, float v, float* out) const {
  const float x = std::clamp((u + 0.5f) * kReservoirColumns - 0.5f, 0.0f, kReservoirColumns - 1.0f);
  const float y = std::clamp((v + 0.5f) * kReservoirRows - 0.5f, 0.0f, kReservoirRows - 1.0f);
  const int i = std::min(static_cast<int>(x), kReservoirColumns - 2);
  const int j = std::min(static_cast<int>(y), kReservoirRows - 2);
  const float fx = x - static_cast<float>(i), fy = y - static_cast<float>(j);
  const float* a = texel(j * kReservoirColumns + i);
  const float* c = a + static_cast<std::ptrdiff_t>(kReservoirColumns) * stride_;
  blend_texels(a, a + stride_, c, c + stride_,
               {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy}, stride_, out);
}

void Reservoir::sample_row(const TipRow& tip, int first, int n, float* out) const {
  CellTexels at;
  for (int done = 0; done < n; done += kSampledCells) {
    const int cells = std::min(kSampledCells, n - done);
    find_texels(tip, first + done, cells, at);
    float* to = out + static_cast<std::ptrdiff_t>(done) * stride_;
    if (stride_ == 4) {
      blend_cells<4>(data_.data(), stride_, at, cells, to);
    } else {
      blend_cells<0>(data_.data(), stride_, at, cells, to);
    }
  }
}

void Reservoir::sample_planes(const TipRow& tip, int first, int n, float* out) const {
  PENTIMENTO_CHECK(n % 4 == 0 && n <= kSampledCells);
  CellTexels at;
  find_texels(tip, first, n, at);
  blend_planes(data_.data(), stride_, at, n, out);
}

/// Measures the tip's texels, and brings them nearer to the load if it `gives`. `kStride`: floats
/// per texel; 0: as many as it has.
template <int kStride>
void Reservoir::refill_texels(const PaintLoad& load, const Tip& tip, float refill_frac,
                              bool gives) {
  const int stride = kStride > 0 ? kStride : stride_;
  const float* weight = load.weight.data();
  const float full_m = load.volume_m;
  float* volume_m = volume_.data();
  double surplus = 0;
  for (const TipTexel& t : tip.texels()) {
    float* paint = data_.data() + static_cast<std::ptrdiff_t>(t.index) * stride;
    const float volume = volume_of(paint, weight, stride);
    *volume_m++ = volume;
    surplus += static_cast<double>(t.weight * std::max(0.0f, volume - full_m));
    if (!gives) continue;
    const float scale = refill_frac * std::max(1.0f, volume / full_m);
    mix(load.row(t.index / kReservoirColumns), scale, refill_frac, stride, paint);
  }
  surplus_ = surplus;
}

void Reservoir::refill(const PaintLoad& load, const Tip& tip, float refill_frac) {
  surplus_ = 0;
  if (as_loaded_) return;
  volume_.resize(tip.texels().size());
  const bool gives = load.volume_m > 0 && refill_frac != 0;
  if (stride_ == kPadding) {
    refill_texels<kPadding>(load, tip, refill_frac, gives);
  } else {
    refill_texels<0>(load, tip, refill_frac, gives);
  }
}

void Reservoir::drop_surplus(const PaintLoad& load, const Tip& tip, float frac) {
  if (!(surplus_ > 0)) return;
  const float full_m = load.volume_m;
  const float* volume_m = volume_.data();
  for (const TipTexel& t : tip.texels()) {
    const float volume = *volume_m++;
    if (!(volume > full_m)) continue;
    const float share = std::min(1.0f, frac * t.weight) * (volume - full_m) / volume;
    float* paint = data_.data() + static_cast<std::ptrdiff_t>(t.index) * stride_;
    for (int k = 0; k < stride_; k += 4)
      for (int i = k; i < k + 4; ++i) paint[i] -= share * paint[i];
  }
}

}  // namespace pentimento
