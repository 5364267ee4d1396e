#include "formats/import/read/remarkable_pens.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/optics/srgb.h"

namespace pentimento::sketch {

namespace {
constexpr double kFar_px = 1e6;
constexpr double kHighlight = 0.35, kShade = 0.3;  // opacities: text stays readable under both

log::Rgb linear_of(std::uint32_t rgb) {
  return {kSrgb8ToLinear[rgb >> 16 & 255], kSrgb8ToLinear[rgb >> 8 & 255],
          kSrgb8ToLinear[rgb & 255]};
}

void add_point(ByteReader& in, double x, double y, double width, float pressure, Stroke& stroke) {
  if (in.ok() && !(std::abs(x) <= kFar_px && std::abs(y) <= kFar_px))
    in.fail(fmt::format("place {}, {} is over {} px", x, y, kFar_px));
  if (!in.ok()) return;
  stroke.width = std::max(stroke.width, std::clamp(width, 0.0, kFar_px));
  stroke.has_pressure = true;
  stroke.samples.push_back({.x = x, .y = y, .pressure = std::clamp(pressure, 0.0f, 1.0f)});
}
}  // namespace

void set_pen(std::uint32_t pen, Stroke& stroke) {
  switch (pen) {
    case 6:
    case 8:
      stroke.erases = true;
      break;
    case 5:
    case 18:
      stroke.brush = BrushKind::kFlat;
      stroke.opacity = kHighlight;
      break;
    case 23:
      stroke.opacity = kShade;
      break;
    case 21:
      stroke.brush = BrushKind::kFlat;
      break;
    case 1:
    case 2:
    case 4:
    case 7:
    case 13:
    case 14:
    case 15:
    case 17:
      stroke.brush = BrushKind::kRigger;
      break;
    default:
      break;  // brush and marker are round
  }
}

void set_pen_color(std::uint32_t color, std::uint32_t argb, Stroke& stroke) {
  constexpr std::array<std::uint32_t, 14> kColors = {
      0x000000, 0x7d7d7d, 0xffffff, 0xfbf719, 0x00a650, 0xff80c0, 0x2a5cd8,
      0xd62d20, 0x9d9d9d, 0x000000, 0x59b03a, 0x33b5e5, 0xc03ac0, 0xf7dc33};
  if (color == 9)
    stroke.color = linear_of(argb);
  else
    stroke.color =
        linear_of(kColors[std::min<std::size_t>(color, kColors.size()) % kColors.size()]);
}

void read_long_point(ByteReader& in, Stroke& stroke) {
  const float x = in.f32("x"), y = in.f32("y");
  in.skip(2 * 4, "speed and direction");
  const float width = in.f32("width of a point"), pressure = in.f32("pressure");
  add_point(in, static_cast<double>(x), static_cast<double>(y), static_cast<double>(width),
            pressure, stroke);
}

void read_short_point(ByteReader& in, Stroke& stroke) {
  const float x = in.f32("x"), y = in.f32("y");
  in.skip(2, "speed");
  const double width = in.u16("width of a point") / 4.0;
  in.skip(1, "direction");
  const float pressure = static_cast<float>(in.u8("pressure")) / 255;
  add_point(in, static_cast<double>(x), static_cast<double>(y), width, pressure, stroke);
}

}  // namespace pentimento::sketch
