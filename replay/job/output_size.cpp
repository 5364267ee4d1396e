#include "replay/job/output_size.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

namespace pentimento {

namespace {
constexpr double kMaxSide = 1 << 20;
constexpr double kMetresPerInch = 0.0254;
constexpr double kDefaultPrintDpi = 300;

struct Sheet {
  double width_m = 0, height_m = 0;
};

/// ISO 216: each size is the one before cut in half, in whole millimetres.
std::optional<Sheet> iso_sheet(std::string_view name) {
  if (name.size() != 2 || (name[0] != 'A' && name[0] != 'a')) return std::nullopt;
  if (name[1] < '0' || name[1] > '6') return std::nullopt;
  int width_mm = 841;
  int height_mm = 1189;
  for (int i = 0; i < name[1] - '0'; ++i) {
    const int half = height_mm / 2;
    height_mm = width_mm;
    width_mm = half;
  }
  return Sheet{width_mm / 1000.0, height_mm / 1000.0};
}

/// A positive number at the start of `text`, which loses it.
std::optional<double> take_number(std::string_view& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || !(value > 0) || !std::isfinite(value)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

std::optional<Sheet> measured_sheet(std::string_view text) {
  const std::optional<double> width = take_number(text);
  if (!width || text.empty() || text[0] != 'x') return std::nullopt;
  text.remove_prefix(1);
  const std::optional<double> height = take_number(text);
  if (!height) return std::nullopt;
  constexpr std::array<std::pair<std::string_view, double>, 4> kUnits = {
      {{"cm", 0.01}, {"mm", 0.001}, {"in", kMetresPerInch}, {"m", 1.0}}};
  for (const auto& [unit, metres] : kUnits) {
    if (text == unit) return Sheet{*width * metres, *height * metres};
  }
  return std::nullopt;
}

Result<OutputSize> whole_pixels(double width, double height, double dpi) {
  if (!(width <= kMaxSide && height <= kMaxSide)) {
    return Error{ErrorCode::kLimit, fmt::format("a picture of {:.0f} x {:.0f} pixels is larger "
                                                "than {:.0f} a side",
                                                width, height, kMaxSide)};
  }
  return OutputSize{std::max(1, static_cast<int>(width + 0.5)),
                    std::max(1, static_cast<int>(height + 0.5)), dpi};
}

Result<OutputSize> printed(const SizeRequest& request, double aspect) {
  std::optional<Sheet> sheet = iso_sheet(*request.print);
  if (sheet && aspect > 1) std::swap(sheet->width_m, sheet->height_m);
  if (!sheet) sheet = measured_sheet(*request.print);
  if (!sheet) {
    return Error{ErrorCode::kUsage, "--print " + *request.print +
                                        ": expected a size as 60x45cm, 24x18in, 600x450mm or A2"};
  }
  const double dpi = request.dpi > 0 ? request.dpi : kDefaultPrintDpi;
  const double width_m = std::min(sheet->width_m, sheet->height_m * aspect);
  return whole_pixels(width_m / kMetresPerInch * dpi, width_m / aspect / kMetresPerInch * dpi, dpi);
}
}  // namespace

Result<OutputSize> output_size(const SizeRequest& request, const CanvasGeometry& grid) {
  const int ways = int{request.width.has_value()} + int{request.height.has_value()} +
                   int{request.scale.has_value()} + int{request.print.has_value()};
  if (ways > 1) {
    return Error{ErrorCode::kUsage,
                 "the size is given in more than one way (--width, --height, --scale, --print)"};
  }
  const double aspect = grid.width_m / grid.height_m;
  if (request.width) return whole_pixels(*request.width, *request.width / aspect, request.dpi);
  if (request.height) return whole_pixels(*request.height * aspect, *request.height, request.dpi);
  if (request.print) return printed(request, aspect);
  const double scale = request.scale.value_or(1);
  return whole_pixels(grid.width * scale, grid.height * scale, request.dpi);
}

int detail_wanted(const OutputSize& size, const CanvasGeometry& grid) {
  const int across = (size.width + grid.width - 1) / grid.width;
  const int down = (size.height + grid.height - 1) / grid.height;
  return std::max({across, down, 1});
}

int detail_for(const OutputSize& size, const CanvasGeometry& grid) {
  return std::min(detail_wanted(size, grid), kMostDetail);
}

}  // namespace pentimento
