#include "core/debug/debug_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "core/optics/composite.h"

namespace pentimento {

namespace {
constexpr std::array<std::pair<std::string_view, DebugView>, 5> kNames = {
    {{"height", DebugView::kHeight},
     {"velocity", DebugView::kVelocity},
     {"pigment", DebugView::kPigment},
     {"layers", DebugView::kLayers},
     {"wetness", DebugView::kWetness}}};

constexpr Code8 kAtRest = {24, 24, 24};
constexpr Code8 kBare = {240, 234, 218};
constexpr Code8 kDried = {150, 128, 104};
/// The colours of no layer, one, two and so on. People who are colour blind can tell them apart,
/// too (after Okabe and Ito 2008).
constexpr std::array<Code8, 9> kLayerColors = {{{40, 40, 40},
                                                {86, 180, 233},
                                                {230, 159, 0},
                                                {0, 158, 115},
                                                {240, 228, 66},
                                                {0, 114, 178},
                                                {213, 94, 0},
                                                {204, 121, 167},
                                                {255, 255, 255}}};
/// Dried paint thinner than this is rounding (m).
constexpr float kLeastDried_m = 1e-7f;
constexpr double kTurn = 2 * 3.14159265358979323846;

/// The smallest of 1, 2, 5 times a power of ten that is at least `value` > 0.
double round_up(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    // A rounding error beyond the digit is none.
    if (value <= digit * decade * (1 + 1e-6)) return digit * decade;
  }
  return 10 * decade;
}

/// Most paint is slow, and thin: on an even scale a few cells would leave the rest black.
bool goes_by_root(DebugView view) {
  return view == DebugView::kVelocity || view == DebugView::kPigment;
}

struct ValueRange {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
};

DebugScale scale_of(DebugView view, const ValueRange& range, int layers) {
  DebugScale scale;
  if (view == DebugView::kLayers) {
    scale.to = layers;
    return scale;
  }
  if (view != DebugView::kPigment) {
    scale.unit = view == DebugView::kVelocity ? "mm/s" : "mm";
    scale.unit_size = 1e-3;
  }
  // An empty canvas: a scale of one unit, all of it at its lower end.
  scale.to = range.most > 0 ? round_up(range.most) : scale.unit_size;
  if (range.least < 0 && std::isfinite(range.least)) scale.from = -round_up(-range.least);
  return scale;
}
}  // namespace

std::optional<DebugView> debug_view_named(std::string_view name) {
  for (const auto& [known, view] : kNames) {
    if (known == name) return view;
  }
  return std::nullopt;
}

std::string_view debug_view_name(DebugView view) {
  return kNames[static_cast<std::size_t>(view)].first;
}

DebugScale measure_debug_scale(DebugView view, const CanvasSource& canvas,
                               const ChannelBasis& basis) {
  if (view == DebugView::kLayers) return scale_of(view, {}, canvas.layers());
  const DebugColors colors(view, {});
  DebugRows rows(colors, canvas, basis);
  const auto width = static_cast<std::size_t>(canvas.geometry().width);
  std::vector<float> value(width);
  std::vector<std::int8_t> mark(width);
  ValueRange range;
  for (int y = 0; y < canvas.geometry().height; ++y) {
    rows.read(y, value, mark);
    for (std::size_t x = 0; x < width; ++x) {
      const double v = static_cast<double>(value[x]);
      if (mark[x] >= 0 || !std::isfinite(v)) continue;
      range.least = std::min(range.least, v);
      range.most = std::max(range.most, v);
    }
  }
  return scale_of(view, range, canvas.layers());
}

double DebugColors::share_of(double value) const {
  const double share = (value - scale_.from) / (scale_.to - scale_.from);
  return goes_by_root(view_) ? std::sqrt(std::max(share, 0.0)) : share;
}

double DebugColors::value_at(double share) const {
  const double linear = goes_by_root(view_) ? share * share : share;
  return scale_.from + (scale_.to - scale_.from) * linear;
}

Linear3 DebugColors::at(double value) const {
  if (!std::isfinite(value)) return linear_of(kNotFiniteColor);
  switch (view_) {
    case DebugView::kHeight:
      return color_at(viridis(), share_of(value));
    case DebugView::kVelocity:
      return moving(value, 0);
    case DebugView::kPigment:
      return color_at(magma(), share_of(value));
    case DebugView::kLayers:
      return linear_of(kLayerColors[static_cast<std::size_t>(
          std::clamp(value, 0.0, static_cast<double>(kLayerColors.size() - 1)))]);
    case DebugView::kWetness:
      break;
  }
  return color_at(blues(), share_of(value));
}

Linear3 DebugColors::moving(double x_m_s, double y_m_s) const {
  const double speed = std::sqrt(x_m_s * x_m_s + y_m_s * y_m_s);
  if (!std::isfinite(speed)) return linear_of(kNotFiniteColor);
  // Red is to the right, and the circle goes against the clock as seen.
  return hue_over(kAtRest, std::atan2(-y_m_s, x_m_s) / kTurn, share_of(speed));
}

std::vector<DebugSwatch> DebugColors::swatches() const {
  if (view_ == DebugView::kWetness) return {{kBare, "bare"}, {kDried, "dried"}};
  std::vector<DebugSwatch> out;
  for (int i = 0; view_ == DebugView::kLayers && i <= static_cast<int>(scale_.to); ++i) {
    out.push_back({kLayerColors[std::min(static_cast<std::size_t>(i), kLayerColors.size() - 1)],
                   std::to_string(i)});
  }
  return out;
}

DebugRows::DebugRows(const DebugColors& colors, const CanvasSource& canvas,
                     const ChannelBasis& basis)
    : colors_(colors), canvas_(canvas), basis_(basis) {
  const auto width = static_cast<std::size_t>(canvas.geometry().width);
  for (std::vector<float>& line : lines_) line.resize(width);
  values_.resize(width);
  marks_.resize(width);
}

std::span<const float> DebugRows::plane(PlaneId id, int y, std::size_t slot) {
  canvas_.read(id, 0, y, lines_[slot]);
  return lines_[slot];
}

void DebugRows::read(int y, std::span<float> value, std::span<std::int8_t> mark) {
  std::fill(mark.begin(), mark.end(), std::int8_t{-1});
  switch (colors_.view()) {
    case DebugView::kHeight: {
      const auto base = plane({PlaneKind::kBase}, y, 0), depth = plane({PlaneKind::kDepth}, y, 1);
      for (std::size_t x = 0; x < value.size(); ++x) value[x] = base[x] + depth[x];
      return;
    }
    case DebugView::kVelocity: {
      const auto u = plane({PlaneKind::kVelocityX}, y, 0);
      const auto v = plane({PlaneKind::kVelocityY}, y, 1);
      for (std::size_t x = 0; x < value.size(); ++x)
        value[x] = std::sqrt(u[x] * u[x] + v[x] * v[x]);
      return;
    }
    case DebugView::kPigment:
      return read_pigment(y, value);
    case DebugView::kLayers:
      return count_layers(y, value);
    case DebugView::kWetness:
      return read_wetness(y, value, mark);
  }
}

void DebugRows::read_pigment(int y, std::span<float> value) {
  std::fill(value.begin(), value.end(), 0.0f);
  for (int layer = 0; layer < canvas_.layers(); ++layer) {
    for (int c = 0; c < canvas_.channels(); ++c) {
      const float share = basis_.amount[c];
      if (share == 0) continue;
      const auto amount = plane(pigment_plane(layer, c), y, 0);
      for (std::size_t x = 0; x < value.size(); ++x) value[x] += share * amount[x];
    }
  }
}

void DebugRows::count_layers(int y, std::span<float> value) {
  std::fill(value.begin(), value.end(), 0.0f);
  std::vector<float>& total = lines_[1];
  for (int layer = 0; layer < canvas_.layers(); ++layer) {
    std::fill(total.begin(), total.end(), 0.0f);
    for (int c = 0; c < canvas_.channels(); ++c) {
      const auto amount = plane(pigment_plane(layer, c), y, 0);
      for (std::size_t x = 0; x < total.size(); ++x) total[x] += basis_.amount[c] * amount[x];
    }
    for (std::size_t x = 0; x < total.size(); ++x) {
      if (!std::isfinite(total[x])) value[x] = total[x];
      if (total[x] >= kEmptyLayerAmount) value[x] += 1;
    }
  }
}

void DebugRows::read_wetness(int y, std::span<float> value, std::span<std::int8_t> mark) {
  const auto depth = plane({PlaneKind::kDepth}, y, 0);
  const auto base = plane({PlaneKind::kBase}, y, 1), paper = plane({PlaneKind::kPaper}, y, 2);
  for (std::size_t x = 0; x < value.size(); ++x) {
    value[x] = depth[x];
    if (depth[x] == 0) mark[x] = base[x] - paper[x] > kLeastDried_m ? 1 : 0;
  }
}

void DebugRows::paint(int y, std::span<Linear3> out) {
  if (colors_.view() == DebugView::kVelocity) {
    const auto u = plane({PlaneKind::kVelocityX}, y, 0);
    const auto v = plane({PlaneKind::kVelocityY}, y, 1);
    for (std::size_t x = 0; x < out.size(); ++x)
      out[x] = colors_.moving(static_cast<double>(u[x]), static_cast<double>(v[x]));
    return;
  }
  read(y, values_, marks_);
  const std::vector<DebugSwatch> apart = colors_.swatches();
  for (std::size_t x = 0; x < out.size(); ++x) {
    out[x] = marks_[x] >= 0 ? linear_of(apart[static_cast<std::size_t>(marks_[x])].color)
                            : colors_.at(static_cast<double>(values_[x]));
  }
}

}  // namespace pentimento
