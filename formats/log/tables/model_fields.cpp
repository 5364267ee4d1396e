#include "formats/log/tables/model_fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "core/optics/spectral/bands.h"

namespace pentimento::log {

namespace {

using enum ParameterKind;

constexpr std::array<std::string_view, 2> kSchemes = {"paper", "conservative"};
constexpr std::array<std::string_view, 2> kOpticalThicknesses = {"amount", "depth"};
constexpr std::array<std::string_view, 2> kOptics = {"rgb", "spectral"};
constexpr std::array<std::string_view, 8> kIlluminants = {"A",   "D50", "D55", "D65",
                                                          "D75", "E",   "F2",  "F11"};
constexpr std::array<std::string_view, 2> kObservers = {"1931", "1964"};

// Bounds are generous: they keep out what single precision or a finite run cannot hold, not what
// looks odd. Lower bounds that stand for "positive" are far above the smallest normal float.
const ModelField kFields[] = {
    {{"scheme", "", kChoice, 0, 1, kSchemes, "the fluid solver"}, false, &Model::scheme},
    {{"layers", "", kWhole, 1, kMaxLayers, {}, "pigment layers; Table 2 of the paper"},
     false,
     &Model::layers},
    {{"nu_min", "m^2/s", kNumber, 1e-12, 1e3, {}, "Table 1"}, true, &Model::nu_min_m2_s},
    {{"nu_max", "m^2/s", kNumber, 1e-12, 1e3, {}, "Table 1"}, true, &Model::nu_max_m2_s},
    {{"max_pigment", "", kNumber, 1e-6, 1e3, {}, "Table 1"}, true, &Model::max_pigment},
    {{"max_medium", "m", kNumber, 1e-6, 10, {}, "Table 1"}, true, &Model::max_medium_m},
    {{"gamma", "", kNumber, 0, 1, {}, "Table 1"}, true, &Model::gamma},
    {{"zeta", "", kNumber, 0, 1, {}, "Table 1"}, true, &Model::zeta},
    {{"jacobi_iterations", "", kWhole, 1, 10000, {}, "Table 1; scheme `paper`"},
     true,
     &Model::jacobi_iterations},
    {{"gravity_cutoff", "of max_medium", kNumber, 0, 1, {}, "the paper's example of 1 %"},
     true,
     &Model::gravity_cutoff_frac},
    {{"velocity_threshold", "m/s", kNumber, 0, 10, {}, "slower paint stands; not in the paper"},
     true,
     &Model::velocity_threshold_m_s},
    {{"bed_friction", "of 3 nu/d^2", kNumber, 0, 100, {}, "no slip at the canvas; `conservative`"},
     true,
     &Model::bed_friction},
    {{"friction_viscosity_floor", "m^2/s", kNumber, 0, 1e3, {}, "nu_min alone runs off the canvas"},
     true,
     &Model::friction_viscosity_floor_m2_s},
    {{"speed_cap", "m/s", kNumber, 0, 1e3, {}, "2 sqrt(9.81 max_medium); 0 = off"},
     true,
     &Model::speed_cap_m_s},
    {{"pigment_residue", "", kNumber, 0, 1e3, {}, "sticks to the paper for ever; not in the paper"},
     true,
     &Model::pigment_residue},
    {{"phi_scales_lateral", "", kFlag, 0, 1, {}, "thick paint withstands gravity along the canvas"},
     true,
     &Model::phi_scales_lateral},
    {{"superbee", "", kFlag, 0, 1, {}, "sharper fronts; `conservative`"}, true, &Model::superbee},
    {{"brush_push", "", kNumber, 0, 0.66, {}, "1.5 times it must stay below 1; `conservative`"},
     true,
     &Model::brush_push},
    {{"layer_speed", "", kNumber, 0, 2, {}, "2: medium and pigment run together; 1 is the paper's"},
     true,
     &Model::layer_speed},
    {{"crowding", "m/s^2", kNumber, 0, 1e5, {}, "keeps motion from heaping past max_medium"},
     true,
     &Model::crowding_m_s2},
    {{"sleep_tile", "m", kNumber, 1e-4, 10, {}, "paint at rest costs nothing, tile by tile"},
     false,
     &Model::sleep_tile_m},
    {{"front_depth",
      "m",
      kNumber,
      0,
      10,
      {},
      "surface tension holds thinner edges; `conservative`"},
     true,
     &Model::front_depth_m},
    {{"front_reach", "m", kNumber, 1e-4, 0.1, {}, "width of a run's head; `conservative`"},
     true,
     &Model::front_reach_m},
    {{"surface_tension",
      "N/m",
      kNumber,
      0,
      10,
      {},
      "oil has 0.032; smooths the surface of runny paint; `conservative`"},
     true,
     &Model::surface_tension_N_m},
    {{"wake_gravity", "m/s^2", kNumber, 0, 100, {}, "a hand's tremor wakes nothing"},
     true,
     &Model::wake_gravity_m_s2},
    {{"most_cells_moved",
      "cells",
      kNumber,
      0.01,
      1e3,
      {},
      "faster paint takes several parts a step"},
     true,
     &Model::most_cells_moved},
    {{"most_parts_of_step", "", kWhole, 1, 1000, {}, "bounds the cost of a step"},
     true,
     &Model::most_parts_of_step},
    {{"viscosity_cycles",
      "",
      kWhole,
      1,
      100,
      {},
      "V-cycles per component; depths within 4e-3 of converged"},
     true,
     &Model::viscosity_cycles},
    {{"height_cycles", "", kWhole, 1, 100, {}, "V-cycles; with 2 waves grow on films of 5 mm"},
     true,
     &Model::height_cycles},
    {{"film_medium", "m", kNumber, 0, 10, {}, "one pass with a full brush deposits 2 mm"},
     true,
     &Model::film_medium_m},
    {{"film_pigment", "", kNumber, 0, 1e3, {}, "one pass with a full brush"},
     true,
     &Model::film_pigment},
    {{"contact_levelling", "", kNumber, 0, 1, {}, "else the weave prints through 2 mm of paint"},
     true,
     &Model::contact_levelling},
    {{"optical_thickness", "", kChoice, 0, 1, kOpticalThicknesses, "glazing: thinned is clearer"},
     true,
     &Model::optical_thickness},
    {{"pigment_reference", "", kNumber, 1e-6, 1e3, {}, "amount of optical thickness 1"},
     true,
     &Model::pigment_reference},
    {{"depth_reference", "m", kNumber, 1e-9, 10, {}, "depth of optical thickness 1, for `depth`"},
     true,
     &Model::depth_reference_m},
    {{"optics", "", kChoice, 0, 1, kOptics,
      "picked colours are RGB; `spectral` mixes as paint does"},
     false,
     &Model::optics},
    {{"bands", "", kWhole, 3, 38, {}, "of `spectral`; the fewest within 0.5 CIEDE2000 of all 38"},
     false,
     &Model::bands},
    {{"illuminant", "", kChoice, 0, 7, kIlluminants, "light on `spectral` paint; sRGB's is D65"},
     false,
     &Model::illuminant},
    {{"observer", "", kChoice, 0, 1, kObservers, "whose colours; sRGB's is the CIE's of 1931"},
     false,
     &Model::observer},
    {{"saunderson_k1", "", kNumber, 0, 0.5, {}, "gloss is the picture's own"},
     false,
     &Model::saunderson_k1},
    {{"saunderson_k2", "", kNumber, 0, 0.95, {}, "no interface; `optics` of the header may set it"},
     false,
     &Model::saunderson_k2},
};

}  // namespace

std::span<const ModelField> model_fields() {
  return kFields;
}

const ModelField* find_model_field(std::string_view name) {
  for (const ModelField& field : kFields) {
    if (field.name == name) return &field;
  }
  return nullptr;
}

double get_model_value(const ModelField& field, const Model& model) {
  return std::visit([&](auto member) { return static_cast<double>(model.*member); }, field.member);
}

void set_model_value(const ModelField& field, Model& model, double value) {
  std::visit(
      [&](auto member) {
        using Value = std::remove_reference_t<decltype(model.*member)>;
        if constexpr (std::is_enum_v<Value>) {
          model.*member = static_cast<Value>(static_cast<int>(value));
        } else if constexpr (std::is_same_v<Value, bool>) {
          model.*member = value != 0;
        } else {
          model.*member = static_cast<Value>(value);
        }
      },
      field.member);
}

std::string model_value_json(const ModelField& field, const Model& model) {
  return value_json(field, get_model_value(field, model));
}

std::string model_problem(const Model& model) {
  if (!(model.nu_min_m2_s < model.nu_max_m2_s)) {
    return fmt::format("nu_min {} is not below nu_max {}", model.nu_min_m2_s, model.nu_max_m2_s);
  }
  if (!(model.gamma < model.zeta)) {
    return fmt::format("gamma {} is not below zeta {}", model.gamma, model.zeta);
  }
  const std::span<const int> counts = band_counts();
  if (std::find(counts.begin(), counts.end(), model.bands) == counts.end()) {
    return fmt::format("bands {} is none of {}", model.bands, fmt::join(counts, ", "));
  }
  return {};
}

Result<void> set_model_text(Model& model, std::string_view name, std::string_view text) {
  const ModelField* field = find_model_field(name);
  if (field == nullptr) {
    return Error{ErrorCode::kUsage, fmt::format("there is no model parameter \"{}\"", name)};
  }
  const Result<double> value = parse_value(*field, text);
  if (!value) return value.error();
  set_model_value(*field, model, *value);
  return {};
}

}  // namespace pentimento::log
