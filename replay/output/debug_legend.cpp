#include "replay/output/debug_legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "formats/image/draw_text.h"

namespace pentimento {

namespace {
constexpr Code8 kPage = {250, 250, 250};
constexpr Code8 kInk = {20, 20, 20};
constexpr int kUnitWidth = 800;  // pictures this wide have letters of the smallest size
constexpr int kMostUnits = 16;

int unit_of(int width) {
  return std::clamp(width / kUnitWidth, 1, kMostUnits);
}

std::string title_of(const DebugColors& colors) {
  const std::string unit = colors.scale().unit;
  switch (colors.view()) {
    case DebugView::kHeight:
      return "height of the surface, " + unit;
    case DebugView::kVelocity:
      return "speed, " + unit + " (disc: direction)";
    case DebugView::kPigment:
      return "pigment in all layers, amount";
    case DebugView::kLayers:
      return "layers that hold pigment";
    case DebugView::kWetness:
      return "depth of wet paint, " + unit;
  }
  return {};
}

/// As many numbers as it takes for the numbers between the ends to be round: 0, 0.5, 1, 1.5, 2; 0,
/// 1, 2, 3, 4, 5.
int even_parts(const DebugScale& scale) {
  const double two = (scale.to - scale.from) / std::pow(10.0, std::floor(std::log10(scale.to)));
  return std::abs(two - 2) < 1e-6 ? 4 : 5;
}

/// Places are in multiples of the size of letters, so that a large picture has a large legend.
class Legend {
 public:
  Legend(const DebugColors& colors, int width)
      : colors_(colors),
        unit_(unit_of(width)),
        width_(width),
        ink_(width, debug_legend_height(width)) {
    for (std::size_t c = 0; c < 3; ++c)
      page_[c] = Field<float>(width, ink_.height(), linear_of(kPage)[c]);
  }

  Result<std::array<Field<float>, 3>> draw() {
    write(title_of(colors_), kMargin * unit_, kTitle * unit_);
    int end = width_ - kMargin * unit_;
    if (colors_.view() == DebugView::kVelocity) end = draw_disc(end);
    const bool only_swatches = colors_.view() == DebugView::kLayers;
    const auto count = static_cast<int>(colors_.swatches().size());
    if (only_swatches) {
      draw_swatches(kMargin * unit_);
    } else {
      if (count > 0) draw_swatches(end -= count * kSwatch * unit_);
      draw_bar(kMargin * unit_, end);
    }
    if (!problem_) return problem_.error();
    blend_ink();
    return std::move(page_);
  }

 private:
  // Of one unit: the heights of the title's base line, of the bar and of the numbers' base line.
  static constexpr int kMargin = 12, kTitle = 16, kBarTop = 24, kBarEnd = 38, kNumbers = 53;
  static constexpr int kSwatch = 52, kSwatchSide = 40, kDiscRadius = 24;
  static constexpr double kLetters = 0.42;

  TextStyle style() const { return {kLetters * unit_, unit_}; }

  void write(const std::string& text, int x, int y) {
    if (Result<void> drawn = draw_text(text, style(), x, y, ink_); !drawn) problem_ = drawn;
  }

  void write_centred(const std::string& text, int x, int y) {
    const Result<int> wide = text_width(text, style());
    if (!wide) {
      problem_ = wide.error();
      return;
    }
    const int most = width_ - *wide - 2 * unit_;
    write(text, std::max(std::min(x - *wide / 2, most), 2 * unit_), y);
  }

  void set(int x, int y, const Linear3& color) {
    for (std::size_t c = 0; c < 3; ++c) page_[c](x, y) = color[c];
  }

  void fill(int x0, int x1, const auto& color_of) {
    for (int x = std::max(x0, 0); x < std::min(x1, width_); ++x) {
      const Linear3 color = color_of(x);
      for (int y = kBarTop * unit_; y < kBarEnd * unit_; ++y) set(x, y, color);
    }
  }

  void draw_bar(int begin, int end) {
    const int last = std::max(end - 1, begin + 1);
    fill(begin, last + 1, [&](int x) {
      return colors_.at(colors_.value_at(static_cast<double>(x - begin) / (last - begin)));
    });
    const DebugScale& scale = colors_.scale();
    const int parts = last - begin > 360 * unit_ ? even_parts(scale) : 2;
    for (int i = 0; i <= parts; ++i) {
      const double value = scale.from + (scale.to - scale.from) * i / parts;
      const int x = begin + static_cast<int>(std::lround(colors_.share_of(value) * (last - begin)));
      for (int y = kBarEnd * unit_; y < (kBarEnd + 3) * unit_; ++y) {
        for (int wide = 0; wide < unit_; ++wide) ink_(std::min(x + wide, width_ - 1), y) = 255;
      }
      write_centred(fmt::format("{:.4g}", value / scale.unit_size + 0.0), x, kNumbers * unit_);
    }
  }

  void draw_swatches(int x) {
    for (const DebugSwatch& swatch : colors_.swatches()) {
      const Linear3 color = linear_of(swatch.color);
      const int begin = x + (kSwatch - kSwatchSide) * unit_;
      fill(begin, begin + kSwatchSide * unit_, [&](int) { return color; });
      write_centred(swatch.name, begin + kSwatchSide / 2 * unit_, kNumbers * unit_);
      x += kSwatch * unit_;
    }
  }

  /// Draws the circle of directions: the largest speed on the rim, rest in the middle. Returns
  /// where the bar ends.
  int draw_disc(int end) {
    const int radius = kDiscRadius * unit_;
    const int cx = end - radius, cy = ink_.height() / 2;
    const double most = colors_.scale().to;
    for (int y = -radius; y <= radius; ++y) {
      for (int x = -radius; x <= radius; ++x) {
        const double far = std::sqrt(static_cast<double>(x * x + y * y)) / radius;
        if (far > 1 || cx + x < 0) continue;
        const double speed = most * far;  // times the direction, which far has in it once
        set(cx + x, cy + y, colors_.moving(speed * x / radius, speed * y / radius));
      }
    }
    return cx - radius - kMargin * unit_;
  }

  void blend_ink() {
    const Linear3 ink = linear_of(kInk);
    for (int y = 0; y < ink_.height(); ++y) {
      for (int x = 0; x < width_; ++x) {
        const float share = static_cast<float>(ink_(x, y)) / 255;
        for (std::size_t c = 0; share > 0 && c < 3; ++c) {
          page_[c](x, y) += share * (ink[c] - page_[c](x, y));
        }
      }
    }
  }

  const DebugColors& colors_;
  int unit_;
  int width_;
  std::array<Field<float>, 3> page_;
  Field<std::uint8_t> ink_;  // how much of it covers each pixel, of 255
  Result<void> problem_;
};
}  // namespace

int debug_legend_height(int width) {
  constexpr int kRows = 60;
  return kRows * unit_of(width);
}

Result<std::array<Field<float>, 3>> draw_debug_legend(const DebugColors& colors, int width) {
  return Legend(colors, width).draw();
}

}  // namespace pentimento
