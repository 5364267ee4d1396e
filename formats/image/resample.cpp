#include "formats/image/resample.h"

#include <vector>

#include "core/base/check.h"

namespace pentimento {

namespace {

/// How one target pixel is made along one axis: source indices and their weights, which sum to 1.
struct AxisTaps {
  std::vector<int> index;
  std::vector<float> weight;
};
using AxisPlan = std::vector<AxisTaps>;

int floor_of(double v) {
  const int whole = static_cast<int>(v);
  return v < whole ? whole - 1 : whole;
}
int clamped(int i, int n) {
  return i < 0 ? 0 : (i >= n ? n - 1 : i);
}
int wrapped(int i, int n) {
  const int r = i % n;
  return r < 0 ? r + n : r;
}

/// The pixels that [begin, end) covers, each weighted with the length covered. Indices may lie
/// outside the source: the caller clamps or wraps.
AxisTaps cover(double begin, double end) {
  AxisTaps taps;
  const double length = end - begin;
  for (int i = floor_of(begin); i < end; ++i) {
    const double from = begin > i ? begin : i;
    const double to = end < i + 1 ? end : i + 1;
    if (to <= from) continue;
    taps.index.push_back(i);
    taps.weight.push_back(static_cast<float>((to - from) / length));
  }
  return taps;
}

AxisTaps between(double position) {
  const double at = position - 0.5;
  const int i = floor_of(at);
  const float f = static_cast<float>(at - i);
  return {{i, i + 1}, {1 - f, f}};
}

/// Keys, Cubic convolution interpolation, IEEE ASSP 29 (1981), a = -1/2: third order.
AxisTaps cubic(double position) {
  const double at = position - 0.5;
  const int i = floor_of(at);
  const double f = at - i;
  const double w0 = ((-0.5 * f + 1.0) * f - 0.5) * f;
  const double w1 = (1.5 * f - 2.5) * f * f + 1.0;
  const double w2 = ((-1.5 * f + 2.0) * f + 0.5) * f;
  const double w3 = (0.5 * f - 0.5) * f * f;
  return {{i - 1, i, i + 1, i + 2},
          {static_cast<float>(w0), static_cast<float>(w1), static_cast<float>(w2),
           static_cast<float>(w3)}};
}

enum class FilterKind { kArea, kLinear, kCubic };

/// Along an axis on which `per_target` source pixels make one target pixel.
AxisPlan make_axis(FilterKind kind, int target, double per_target) {
  AxisPlan axis;
  for (int i = 0; i < target; ++i) {
    const double centre = (i + 0.5) * per_target;
    axis.push_back(kind == FilterKind::kArea     ? cover(i * per_target, (i + 1) * per_target)
                   : kind == FilterKind::kLinear ? between(centre)
                                                 : cubic(centre));
  }
  return axis;
}

void clamp_axis(AxisPlan& axis, int source) {
  for (AxisTaps& taps : axis)
    for (int& i : taps.index) i = clamped(i, source);
}
void wrap_axis(AxisPlan& axis, int source) {
  for (AxisTaps& taps : axis)
    for (int& i : taps.index) i = wrapped(i, source);
}

/// Rows first, then columns; taps in order.
Field<float> apply(FieldView<const float> source, const AxisPlan& across, const AxisPlan& down) {
  const int width = static_cast<int>(across.size());
  const int height = static_cast<int>(down.size());
  Field<float> narrow(width, source.height());
  for (int y = 0; y < source.height(); ++y) {
    const float* in = source.row(y);
    for (int x = 0; x < width; ++x) {
      const AxisTaps& taps = across[static_cast<std::size_t>(x)];
      float sum = 0;
      for (std::size_t k = 0; k < taps.index.size(); ++k) sum += taps.weight[k] * in[taps.index[k]];
      narrow(x, y) = sum;
    }
  }
  Field<float> out(width, height);
  for (int y = 0; y < height; ++y) {
    const AxisTaps& taps = down[static_cast<std::size_t>(y)];
    float* to = out.row(y);
    for (std::size_t k = 0; k < taps.index.size(); ++k) {
      const float* in = narrow.row(taps.index[k]);
      const float weight = taps.weight[k];
      for (int x = 0; x < width; ++x) to[x] += weight * in[x];
    }
  }
  return out;
}

AxisPlan fitted_axis(FilterKind kind, int source, int target) {
  AxisPlan axis = make_axis(kind, target, static_cast<double>(source) / target);
  clamp_axis(axis, source);
  return axis;
}

Field<float> resample(FieldView<const float> source, int width, int height, FilterKind kind) {
  PENTIMENTO_CHECK(!source.empty() && width > 0 && height > 0);
  return apply(source, fitted_axis(kind, source.width(), width),
               fitted_axis(kind, source.height(), height));
}

AxisPlan tiled_axis(int tile, int cells, double cells_per_repeat) {
  const double per_cell = tile / cells_per_repeat;
  AxisPlan axis =
      make_axis(per_cell > 1 ? FilterKind::kArea : FilterKind::kLinear, cells, per_cell);
  wrap_axis(axis, tile);
  return axis;
}

AxisPlan sized_axis(int source, int target) {
  return fitted_axis(target < source ? FilterKind::kArea : FilterKind::kLinear, source, target);
}

}  // namespace

Field<float> resample_area(FieldView<const float> source, int width, int height) {
  return resample(source, width, height, FilterKind::kArea);
}

Field<float> resample_bilinear(FieldView<const float> source, int width, int height) {
  return resample(source, width, height, FilterKind::kLinear);
}

Field<float> resample_bicubic(FieldView<const float> source, int width, int height) {
  return resample(source, width, height, FilterKind::kCubic);
}

Field<float> resample_to(FieldView<const float> source, int width, int height) {
  PENTIMENTO_CHECK(!source.empty() && width > 0 && height > 0);
  return apply(source, sized_axis(source.width(), width), sized_axis(source.height(), height));
}

Field<float> sample_repeated(FieldView<const float> tile, int width, int height,
                             double cells_per_repeat_x, double cells_per_repeat_y) {
  PENTIMENTO_CHECK(!tile.empty() && width > 0 && height > 0);
  PENTIMENTO_CHECK(cells_per_repeat_x > 0 && cells_per_repeat_y > 0);
  return apply(tile, tiled_axis(tile.width(), width, cells_per_repeat_x),
               tiled_axis(tile.height(), height, cells_per_repeat_y));
}

struct PictureRows::Plan {
  Field<float> source;
  AxisPlan across, down;
};

PictureRows PictureRows::fitted(Field<float> picture, int width, int height) {
  PENTIMENTO_CHECK(!picture.empty() && width > 0 && height > 0);
  AxisPlan across = sized_axis(picture.width(), width), down = sized_axis(picture.height(), height);
  return PictureRows(
      std::make_shared<Plan>(Plan{std::move(picture), std::move(across), std::move(down)}));
}

PictureRows PictureRows::tiled(Field<float> tile, int width, int height, double cells_per_repeat_x,
                               double cells_per_repeat_y) {
  PENTIMENTO_CHECK(!tile.empty() && width > 0 && height > 0);
  PENTIMENTO_CHECK(cells_per_repeat_x > 0 && cells_per_repeat_y > 0);
  AxisPlan across = tiled_axis(tile.width(), width, cells_per_repeat_x);
  AxisPlan down = tiled_axis(tile.height(), height, cells_per_repeat_y);
  return PictureRows(
      std::make_shared<Plan>(Plan{std::move(tile), std::move(across), std::move(down)}));
}

void PictureRows::row(int x, int y, std::span<float> out) const {
  const AxisTaps& rows = plan_->down[static_cast<std::size_t>(y)];
  for (std::size_t i = 0; i < out.size(); ++i) {
    const AxisTaps& columns = plan_->across[static_cast<std::size_t>(x) + i];
    float value = 0;
    for (std::size_t r = 0; r < rows.index.size(); ++r) {
      const float* in = plan_->source.row(rows.index[r]);
      float sum = 0;
      for (std::size_t c = 0; c < columns.index.size(); ++c)
        sum += columns.weight[c] * in[columns.index[c]];
      value += rows.weight[r] * sum;
    }
    out[i] = value;
  }
}

}  // namespace pentimento
