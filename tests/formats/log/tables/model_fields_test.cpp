#include "formats/log/tables/model_fields.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "formats/log/tables/slider_fields.h"

namespace pentimento::log {
namespace {

TEST(ModelFields, DefaultsLieInTheirRanges) {
  const Model model;
  for (const ModelField& field : model_fields()) {
    EXPECT_EQ(value_problem(field, get_model_value(field, model)), "") << field.name;
  }
  EXPECT_EQ(model_problem(model), "");
}

TEST(ModelFields, EveryFieldIsReadBackAsSet) {
  for (const ModelField& field : model_fields()) {
    Model model;
    set_model_value(field, model, field.max);
    // Single precision holds the bounds to 24 bits.
    EXPECT_FLOAT_EQ(static_cast<float>(get_model_value(field, model)),
                    static_cast<float>(field.max))
        << field.name;
  }
}

TEST(ModelFields, BoundsLieInTheirRangesOnceStored) {
  for (const ModelField& field : model_fields())
    for (const double bound : {field.min, field.max}) {
      Model model;
      set_model_value(field, model, bound);
      EXPECT_EQ(value_problem(field, get_model_value(field, model)), "") << field.name;
    }
  EXPECT_NE(value_problem(*find_model_field("brush_push"), 0.6601), "");
  EXPECT_NE(value_problem(*find_model_field("brush_push"), -1e-6), "");
}

TEST(ModelFields, NamesAreUniqueAcrossBothTables) {
  std::set<std::string_view> names;
  for (const ModelField& field : model_fields()) EXPECT_TRUE(names.insert(field.name).second);
  for (const SliderField& field : slider_fields()) EXPECT_TRUE(names.insert(field.name).second);
}

TEST(ModelFields, TextOfACommandLineSetsAField) {
  Model model;
  EXPECT_TRUE(set_model_text(model, "nu_max", "1e-1").ok());
  EXPECT_EQ(model.nu_max_m2_s, 1e-1f);
  EXPECT_TRUE(set_model_text(model, "scheme", "conservative").ok());
  EXPECT_EQ(model.scheme, SchemeKind::kConservative);
  EXPECT_TRUE(set_model_text(model, "phi_scales_lateral", "false").ok());
  EXPECT_FALSE(model.phi_scales_lateral);
}

TEST(ModelFields, ErrorsNameFieldValueAndLimit) {
  const auto message = [](std::string_view name, std::string_view text) {
    Model model;
    const Result<void> result = set_model_text(model, name, text);
    return result.ok() ? std::string("ok") : result.error().message;
  };
  EXPECT_EQ(message("nu_max", "7000"), "nu_max 7000 is outside 1e-12..1000 m^2/s");
  EXPECT_EQ(message("layers", "2.5"), "layers 2.5 is not a whole number");
  EXPECT_EQ(message("layers", "9"), "layers 9 is outside 1..8");
  EXPECT_EQ(message("gamma", "nan"), "gamma nan is outside 0..1");
  EXPECT_EQ(message("gamma", "0.2x"), "gamma \"0.2x\" is not a number");
  EXPECT_EQ(message("scheme", "fast"), "scheme \"fast\" is not paper or conservative");
  EXPECT_EQ(message("superbee", "yes"), "superbee \"yes\" is not true or false");
  EXPECT_EQ(message("nu", "1"), "there is no model parameter \"nu\"");
}

TEST(ModelFields, FieldsThatContradictEachOtherAreFound) {
  Model model;
  model.gamma = 0.9f;
  EXPECT_EQ(model_problem(model), "gamma 0.9 is not below zeta 0.8");
  model = {};
  model.nu_min_m2_s = 1;
  EXPECT_EQ(model_problem(model), "nu_min 1 is not below nu_max 0.01");
}

TEST(ModelFields, JsonHasShortestDigits) {
  const Model model;
  EXPECT_EQ(model_value_json(*find_model_field("max_medium"), model), "0.05");
  EXPECT_EQ(model_value_json(*find_model_field("nu_min"), model), "1e-06");
  EXPECT_EQ(model_value_json(*find_model_field("layers"), model), "2");
  EXPECT_EQ(model_value_json(*find_model_field("optical_thickness"), model), "\"amount\"");
  EXPECT_EQ(model_value_json(*find_model_field("superbee"), model), "false");
}

TEST(SliderFields, DefaultsLieInTheirRanges) {
  const BrushSettings brush;
  for (const SliderField& field : slider_fields()) {
    EXPECT_EQ(value_problem(field, static_cast<double>(brush.*(field.member))), "") << field.name;
  }
}

TEST(SliderFields, SetTheBrushOrTheModel) {
  BrushSettings brush;
  Model model;
  apply_slider("size", 0.1, brush, model);
  EXPECT_EQ(brush.size_m, 0.1f);
  apply_slider("nu_max", 0.2, brush, model);
  EXPECT_EQ(model.nu_max_m2_s, 0.2f);
}

TEST(SliderFields, WhatIsFixedForALogIsNoSlider) {
  EXPECT_EQ(find_slider("layers"), nullptr);
  EXPECT_EQ(find_slider("scheme"), nullptr);
  EXPECT_NE(find_slider("nu_max"), nullptr);
  EXPECT_NE(find_slider("pickup"), nullptr);
}

}  // namespace
}  // namespace pentimento::log
