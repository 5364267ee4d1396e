#include "replay/palette.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "core/optics/kubelka_munk.h"
#include "core/optics/pigment_library.h"
#include "core/optics/srgb.h"
#include "replay/spectral_pigment.h"

namespace pentimento {

namespace {
constexpr std::string_view kDefaultPigment = "ivory black";

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

Pigment pigment_from_coefficients(const std::string& name, const log::Rgb& K, const log::Rgb& S) {
  return {name, Eigen::Vector3d(K[0], K[1], K[2]), Eigen::Vector3d(S[0], S[1], S[2])};
}
}  // namespace

Result<Pigment> make_pigment(const log::PigmentSpec& spec) {
  if (spec.K && spec.S) return pigment_from_coefficients(spec.name, *spec.K, *spec.S);
  if (spec.spectrum) return pigment_from_spectrum(spec.name, *spec.spectrum);
  if (spec.over_white && spec.over_black) {
    return pigment_from_white_black(spec.name, to_float(*spec.over_white),
                                    to_float(*spec.over_black));
  }
  if (spec.color) {
    return pigment_from_color(spec.name, to_float(*spec.color), static_cast<float>(spec.opacity));
  }
  const Pigment* known = find_library_pigment(spec.name);
  if (known == nullptr) {
    return Error{ErrorCode::kBadInput,
                 "palette: no pigment of the library is called \"" + spec.name + "\""};
  }
  Pigment pigment = *known;
  pigment.name = spec.name;
  return pigment;
}

Result<Palette> Palette::make(const std::vector<log::PigmentSpec>& header) {
  Palette palette;
  for (const log::PigmentSpec& spec : header) {
    Result<Pigment> pigment = make_pigment(spec);
    if (!pigment) return pigment.error();
    palette.append(std::move(*pigment));
  }
  if (palette.pigments_.empty()) {
    const Pigment* black = find_library_pigment(kDefaultPigment);
    PENTIMENTO_CHECK(black != nullptr);
    palette.append(*black);
  }
  return palette;
}

Palette Palette::of(std::vector<Pigment> pigments) {
  Palette palette;
  for (Pigment& pigment : pigments) palette.append(std::move(pigment));
  return palette;
}

void Palette::pick(const log::Color& color) {
  if (!color.value) return;
  const std::string name = hex_name(*color.value);
  if (!index_.contains(name)) append(pigment_from_color(name, to_float(*color.value)));
}

int Palette::find(const log::Color& color) const {
  return find(color.value ? hex_name(*color.value) : color.pigment);
}

void Palette::append(Pigment pigment) {
  index_.emplace(pigment.name, static_cast<int>(pigments_.size()));
  pigments_.push_back(std::move(pigment));
}

}  // namespace pentimento
