#include "replay/log/palette.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "core/optics/srgb.h"

namespace pentimento {

namespace {
constexpr std::string_view kDefaultPigment = "Ivory Black";

std::array<float, 3> to_float(const log::Rgb& rgb) {
  return {static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2])};
}

/// "#rrggbb" of a linear colour, as it was picked.
std::string hex_name(const log::Rgb& linear) {
  std::string name = "#";
  for (const double value : linear) {
    const float encoded = static_cast<float>(linear_to_srgb(value));
    name += fmt::format("{:02x}", static_cast<int>(encoded * 255 + 0.5f));
  }
  return name;
}
}  // namespace

Result<Pigment> make_pigment(const log::PigmentSpec& spec, const PaintMaker& maker) {
  if (spec.K && spec.S) return maker.from_rgb(spec.name, *spec.K, *spec.S);
  if (const auto& s = spec.spectrum)
    return maker.from_spectrum(spec.name, s->wavelength_nm, s->K, s->S);
  if (spec.over_white && spec.over_black) {
    return maker.from_white_black(spec.name, to_float(*spec.over_white),
                                  to_float(*spec.over_black));
  }
  if (spec.color) {
    return maker.from_color(spec.name, to_float(*spec.color), static_cast<float>(spec.opacity));
  }
  std::optional<Pigment> known = maker.from_library(spec.name);
  if (!known) {
    return Error{ErrorCode::kBadInput,
                 "palette: no pigment of the library is called \"" + spec.name + "\""};
  }
  return std::move(*known);
}

Result<Palette> Palette::make(const std::vector<log::PigmentSpec>& header,
                              const PaintMaker& maker) {
  Palette palette;
  palette.maker_ = maker;
  for (const log::PigmentSpec& spec : header) {
    Result<Pigment> pigment = make_pigment(spec, maker);
    if (!pigment) return pigment.error();
    palette.append(std::move(*pigment));
  }
  if (palette.pigments_.empty()) {
    std::optional<Pigment> black = maker.from_library(kDefaultPigment);
    PENTIMENTO_CHECK(black);
    palette.append(std::move(*black));
  }
  return palette;
}

Palette Palette::of(std::vector<Pigment> pigments, const PaintMaker& maker) {
  Palette palette;
  palette.maker_ = maker;
  for (Pigment& pigment : pigments) palette.append(std::move(pigment));
  return palette;
}

void Palette::pick(const log::Color& color) {
  if (!color.value) return;
  const std::string name = hex_name(*color.value);
  if (!index_.contains(name)) append(maker_.from_color(name, to_float(*color.value)));
}

int Palette::find(const log::Color& color) const {
  return find(color.value ? hex_name(*color.value) : color.pigment);
}

void Palette::append(Pigment pigment) {
  index_.emplace(pigment.name, static_cast<int>(pigments_.size()));
  pigments_.push_back(std::move(pigment));
}

}  // namespace pentimento
