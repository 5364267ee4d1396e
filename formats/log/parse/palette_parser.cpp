#include "formats/log/parse/palette_parser.h"

#include <fmt/format.h>

#include <unordered_set>

#include "core/optics/paints/pigment_library.h"
#include "formats/log/json/nearest_name.h"
#include "formats/log/parse/brush_parser.h"
#include "formats/log/tables/ranges.h"

namespace pentimento::log {

namespace {

constexpr std::size_t kMinBands = 3, kMaxBands = 1000;

/// Objects of the array `name`; elements of another kind are a problem.
std::vector<const JsonNode*> objects(Fields& header, std::string_view name) {
  std::vector<const JsonNode*> list = header.elements(name);
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i]->kind != JsonKind::kObject)
      header.fail(fmt::format("{}[{}] is not an object", name, i));
  }
  return list;
}

PigmentSpec::Coefficients parse_spectrum(Fields& pigment, const JsonNode& node) {
  const std::string prefix = fmt::format("{}spectrum.", pigment.prefix());
  Fields fields(pigment.line(), node, prefix);
  PigmentSpec::Coefficients spectrum;
  spectrum.wavelength_nm =
      fields.required("wavelength", fields.numbers("wavelength", kWavelengthRange));
  spectrum.K = fields.required("K", fields.numbers("K", kAbsorptionRange));
  spectrum.S = fields.required("S", fields.numbers("S", kAbsorptionRange));
  const std::size_t bands = spectrum.wavelength_nm.size();
  if (bands < kMinBands || bands > kMaxBands) {
    fields.fail(fmt::format("{}wavelength has {} bands, outside {}..{}", prefix, bands, kMinBands,
                            kMaxBands));
  }
  if (spectrum.K.size() != bands || spectrum.S.size() != bands) {
    fields.fail(fmt::format("{}K has {} and {}S {} values for {} wavelengths", prefix,
                            spectrum.K.size(), prefix, spectrum.S.size(), bands));
  }
  for (std::size_t i = 1; i < bands; ++i) {
    if (spectrum.wavelength_nm[i] > spectrum.wavelength_nm[i - 1]) continue;
    fields.fail(fmt::format("{}wavelength[{}] {} is not above the one before", prefix, i,
                            spectrum.wavelength_nm[i]));
  }
  pigment.fail_unless_empty(fields.finish());
  return spectrum;
}

/// The ways to give a pigment exclude each other.
void check_ways(Fields& fields, const PigmentSpec& pigment, bool has_opacity) {
  const int ways = (pigment.over_white || pigment.over_black ? 1 : 0) + (pigment.color ? 1 : 0) +
                   (pigment.K || pigment.S ? 1 : 0) + (pigment.spectrum ? 1 : 0);
  if (ways > 1) {
    fields.fail(
        fmt::format("{}name \"{}\" is given in more than one way", fields.prefix(), pigment.name));
  }
  if (pigment.over_white.has_value() != pigment.over_black.has_value()) {
    fields.missing(pigment.over_white ? "over_black" : "over_white");
  }
  if (pigment.K.has_value() != pigment.S.has_value()) fields.missing(pigment.K ? "S" : "K");
  if (has_opacity && !pigment.color) fields.missing("color");
  if (ways == 0 && fields.ok() && !in_pigment_library(pigment.name)) {
    fields.reject("name", "is no pigment of the library, and no colour is given" +
                              did_you_mean(pigment.name, library_pigment_names()));
  }
}

void check_colors(Fields& fields, const PigmentSpec& pigment) {
  if (!pigment.over_white || !pigment.over_black) return;
  for (std::size_t i = 0; i < 3; ++i) {
    const double white = (*pigment.over_white)[i], black = (*pigment.over_black)[i];
    if (black <= white) continue;
    fields.reject("over_black",
                  fmt::format("is lighter than over_white ({} > {} in band {})", black, white, i));
  }
}

PigmentSpec parse_pigment(Fields& fields) {
  PigmentSpec pigment;
  pigment.name = fields.required("name", fields.text("name"));
  if (fields.ok() && pigment.name.empty()) fields.reject("name", "is empty");
  pigment.over_white = fields.color("over_white");
  pigment.over_black = fields.color("over_black");
  pigment.color = fields.color("color");
  const std::optional<double> opacity = fields.number("opacity", kUnitRange);
  pigment.opacity = opacity.value_or(pigment.opacity);
  if (opacity && (*opacity <= 0 || *opacity >= 1)) {
    fields.reject("opacity", "is outside 0..1, both excluded");
  }
  pigment.K = fields.triple("K", kAbsorptionRange);
  pigment.S = fields.triple("S", kAbsorptionRange);
  if (const JsonNode* node = fields.object("spectrum")) {
    pigment.spectrum = parse_spectrum(fields, *node);
  }
  check_ways(fields, pigment, opacity.has_value());
  check_colors(fields, pigment);
  pigment.library = !pigment.over_white && !pigment.color && !pigment.K && !pigment.spectrum;
  return pigment;
}

/// Reads an array of named objects; names must differ.
template <typename T>
std::vector<T> parse_named(Fields& header, std::string_view array, T (*parse)(Fields&)) {
  std::vector<T> list;
  std::unordered_set<std::string> names;
  for (const JsonNode* node : objects(header, array)) {
    if (!header.ok()) break;
    const std::string prefix = fmt::format("{}[{}].", array, list.size());
    Fields fields(header.line(), *node, prefix);
    T item = parse(fields);
    if (!names.insert(item.name).second) fields.reject("name", "is there twice");
    header.fail_unless_empty(fields.finish());
    list.push_back(std::move(item));
  }
  return list;
}

}  // namespace

std::vector<PigmentSpec> parse_palette(Fields& header) {
  return parse_named<PigmentSpec>(header, "palette", parse_pigment);
}

std::vector<BrushSpec> parse_brushes(Fields& header) {
  return parse_named<BrushSpec>(header, "brushes", parse_brush_spec);
}

}  // namespace pentimento::log
