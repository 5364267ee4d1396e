#include "formats/log/stroke_preview.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/brush/brush_settings.h"
#include "core/optics/srgb.h"

namespace pentimento::log {

namespace {
constexpr double kMostRows = 60;  // of a narrow canvas, characters
constexpr const char* kUpperHalf = "\u2580";
constexpr int kForeground = 38, kBackground = 48;  // of a terminal's characters

/// What makes a terminal go on in that colour.
std::string color_code(int ground, const Rgb& color) {
  const auto code = [](double linear) {
    return std::lround(255 * linear_to_srgb(std::clamp(linear, 0.0, 1.0)));
  };
  return fmt::format("\x1b[{};2;{};{};{}m", ground, code(color[0]), code(color[1]), code(color[2]));
}

/// The shares of the way from `at` by `way` between which it is in least..most; from above to where
/// it is not.
std::pair<double, double> part_within(double at, double way, double least, double most) {
  if (way == 0) return at >= least && at <= most ? std::pair(0.0, 1.0) : std::pair(1.0, 0.0);
  const double a = (least - at) / way, b = (most - at) / way;
  return {std::clamp(std::min(a, b), 0.0, 1.0), std::clamp(std::max(a, b), 0.0, 1.0)};
}
}  // namespace

std::string color_patch(const Rgb& color) {
  return color_code(kBackground, color) + "  \x1b[0m";
}

StrokePreview::StrokePreview(const Header& header, int columns)
    : width_(std::max(columns, 1)), size_m_(static_cast<double>(BrushSettings().size_m)) {
  const double aspect = header.canvas_height_m / header.canvas_width_m;
  if (aspect * width_ > 2 * kMostRows)
    width_ = std::max(1, static_cast<int>(std::lround(2 * kMostRows / aspect)));
  cell_m_ = header.canvas_width_m / width_;
  height_ = std::max(2, 2 * static_cast<int>(std::ceil(header.canvas_height_m / cell_m_ / 2)));
  clear();
}

void StrokePreview::clear() {
  cells_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), {});
}

std::optional<Rgb> StrokePreview::at(int x, int y) const {
  return cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                static_cast<std::size_t>(x)];
}

void StrokePreview::add(const Event& event) {
  if (const auto* sample = std::get_if<Touch>(&event.action)) return touch(*sample);
  if (std::holds_alternative<Clear>(event.action)) return clear();
  if (const auto* slider = std::get_if<Slider>(&event.action)) {
    if (slider->name == "size") size_m_ = slider->value;
  }
  if (const auto* brush = std::get_if<BrushChange>(&event.action)) wipes_ = brush->name == "rag";
  if (const auto* color = std::get_if<Color>(&event.action)) {
    const auto known = pigments_.find(color->pigment);
    color_ = color->value               ? *color->value
             : known != pigments_.end() ? known->second
                                        : Rgb{0.02, 0.02, 0.02};
  }
}

void StrokePreview::touch(const Touch& touch) {
  if (touch.phase == TouchPhase::kDown) hands_[touch.id] = {touch.x_m, touch.y_m};
  const auto hand = hands_.find(touch.id);
  if (hand == hands_.end()) return;
  const double dx = touch.x_m - hand->second.x_m, dy = touch.y_m - hand->second.y_m;
  // Of a stroke that leaves the canvas only the part that is over it, or near.
  const double width_m = width_ * cell_m_, height_m = height_ * cell_m_;
  const auto [from_x, to_x] = part_within(hand->second.x_m, dx, -width_m, 2 * width_m);
  const auto [from_y, to_y] = part_within(hand->second.y_m, dy, -width_m, height_m + width_m);
  const double from = std::max(from_x, from_y), to = std::min(to_x, to_y);
  const int dabs = static_cast<int>((to - from) * std::hypot(dx, dy) / (0.5 * cell_m_)) + 1;
  for (int i = 0; i <= dabs && from <= to; ++i) {
    const double share = from + (to - from) * i / dabs;
    dab(hand->second.x_m + dx * share, hand->second.y_m + dy * share);
  }
  hand->second = {touch.x_m, touch.y_m};
  if (touch.phase == TouchPhase::kUp || touch.phase == TouchPhase::kCancel) hands_.erase(hand);
}

void StrokePreview::dab(double x_m, double y_m) {
  const double radius = std::clamp(0.5 * size_m_ / cell_m_, 0.5, static_cast<double>(width_));
  const double x = x_m / cell_m_, y = y_m / cell_m_;
  const auto cell = [](double v, int most) {
    return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(most)));
  };
  for (int v = cell(y - radius, height_); v < cell(y + radius + 1, height_); ++v) {
    for (int u = cell(x - radius, width_); u < cell(x + radius + 1, width_); ++u) {
      if (std::hypot(u + 0.5 - x, v + 0.5 - y) > radius) continue;
      cells_[static_cast<std::size_t>(v) * static_cast<std::size_t>(width_) +
             static_cast<std::size_t>(u)] = wipes_ ? std::optional<Rgb>() : color_;
    }
  }
}

std::string StrokePreview::text() const {
  const auto paint = [&](int ground, const std::optional<Rgb>& color) {
    return color ? color_code(ground, *color) : fmt::format("\x1b[{};2;235;232;225m", ground);
  };
  std::string out;
  for (int y = 0; y < height_; y += 2) {
    for (int x = 0; x < width_; ++x)
      out += paint(kForeground, at(x, y)) + paint(kBackground, at(x, y + 1)) + kUpperHalf;
    out += "\x1b[0m\n";
  }
  return out;
}

}  // namespace pentimento::log
