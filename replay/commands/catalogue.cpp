#include "replay/commands/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/brush/builtin_brushes.h"
#include "core/model/model.h"
#include "core/optics/paints/paint_maker.h"
#include "core/optics/paints/pigment_library.h"
#include "formats/import/sketch/recording.h"
#include "formats/log/json/nearest_name.h"
#include "formats/log/tables/limits.h"
#include "formats/log/tables/model_fields.h"
#include "formats/log/tables/slider_fields.h"
#include "replay/job/report_object.h"
#include "replay/log/swatch.h"

namespace pentimento {

namespace {

CatalogueCell text(std::string_view words) {
  return {std::string(words), true};
}
CatalogueCell number(double value) {
  return {fmt::format("{}", static_cast<float>(value)), false};
}

Catalogue pigments() {
  Catalogue out{"pigments", {"name", "over_white", "over_black", "measured"}, {}};
  const auto rgb = rgb_pigment_names();
  for (const std::string_view name : library_pigment_names()) {
    const std::optional<Pigment> paint = PaintMaker().from_library(name);
    if (!paint) continue;
    const bool measured = std::find(rgb.begin(), rgb.end(), name) == rgb.end();
    out.rows.push_back({text(name),
                        text(coat_hex(*paint, 1)),
                        text(coat_hex(*paint, 0)),
                        {measured ? "true" : "false", false}});
  }
  return out;
}

Catalogue brushes() {
  Catalogue out{"brushes", {"name", "size_pressure", "flow_pressure", "capacity"}, {}};
  for (const std::string& name : builtin_brush_names()) {
    const BrushDefinition brush = *builtin_brush(name);
    out.rows.push_back({text(name), number(brush.size_pressure), number(brush.flow_pressure),
                        number(brush.capacity)});
  }
  return out;
}

std::string choices_of(const log::Parameter& parameter) {
  return parameter.choices.empty() ? fmt::format("{}..{}", static_cast<float>(parameter.min),
                                                 static_cast<float>(parameter.max))
                                   : fmt::format("{}", fmt::join(parameter.choices, ", "));
}

/// Where a parameter may stand: in a header's `model`, in a `slider` event.
Catalogue parameters() {
  Catalogue out{"parameters", {"name", "unit", "range", "default", "in", "reason"}, {}};
  const auto add = [&](const log::Parameter& p, const CatalogueCell& value,
                       std::string_view where) {
    out.rows.push_back(
        {text(p.name), text(p.unit), text(choices_of(p)), value, text(where), text(p.reason)});
  };
  const BrushSettings brush;
  for (const log::SliderField& field : log::slider_fields())
    add(field, number(static_cast<double>(brush.*field.member)), "slider");
  const Model model;
  for (const log::ModelField& field : log::model_fields())
    add(field, {log::model_value_json(field, model), false},
        field.while_painting ? "model, slider" : "model");
  return out;
}

Catalogue formats() {
  Catalogue out{"formats", {"name", "extensions", "title"}, {}};
  out.rows.push_back({text("log"), text(".jsonl .jsonl.gz .jsonl.zst"), text("action log")});
  for (const sketch::Format& format : sketch::formats())
    out.rows.push_back({text(format.name), text(format.extensions), text(format.title)});
  return out;
}

/// What a log may not be over, and the option that raises it.
Catalogue limits() {
  Catalogue out{"limits", {"name", "limit", "unit", "option", "reason"}, {}};
  const log::Limits values;
  for (const log::LimitRow& row : log::limit_rows())
    out.rows.push_back({text(row.name),
                        {fmt::format("{}", values.*row.value), false},
                        text(row.unit),
                        text(row.option),
                        text(row.reason)});
  return out;
}

struct CatalogueKind {
  std::string_view name, of_one;
  Catalogue (*make)();
};
constexpr CatalogueKind kKinds[] = {{"brushes", "brush", brushes},
                                    {"pigments", "pigment", pigments},
                                    {"parameters", "parameter", parameters},
                                    {"formats", "format", formats},
                                    {"limits", "limit", limits}};

std::string lower(std::string_view words) {
  std::string out(words);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}
}  // namespace

std::vector<std::string_view> catalogue_names() {
  std::vector<std::string_view> names;
  for (const CatalogueKind& kind : kKinds) names.push_back(kind.name);
  return names;
}

Result<Catalogue> catalogue(std::string_view kind, std::string_view name) {
  const auto* found = std::find_if(std::begin(kKinds), std::end(kKinds),
                                   [&](const CatalogueKind& k) { return k.name == kind; });
  if (found == std::end(kKinds))
    return Error{ErrorCode::kUsage, fmt::format("there is no list of \"{}\"{}; there are {}", kind,
                                                did_you_mean(kind, catalogue_names()),
                                                fmt::join(catalogue_names(), ", "))};
  Catalogue all = found->make();
  if (name.empty()) return all;
  Catalogue out{all.kind, all.columns, {}};
  std::vector<std::string_view> names;
  for (const std::vector<CatalogueCell>& row : all.rows) {
    names.push_back(row.front().text);
    if (lower(row.front().text).find(lower(name)) != std::string::npos) out.rows.push_back(row);
  }
  if (!out.rows.empty()) return out;
  return Error{ErrorCode::kUsage, fmt::format("no {} is called \"{}\"{}", found->of_one, name,
                                              did_you_mean(name, names))};
}

std::string catalogue_json(const Catalogue& catalogue) {
  std::vector<std::string> items;
  for (const std::vector<CatalogueCell>& row : catalogue.rows) {
    ReportObject item;
    for (std::size_t c = 0; c < row.size(); ++c)
      item.add_json(catalogue.columns[c], row[c].is_text ? json_string(row[c].text) : row[c].text);
    items.push_back(item.text());
  }
  return ReportObject().add_json(catalogue.kind, json_array(items)).text();
}

std::string catalogue_text(const Catalogue& catalogue) {
  std::vector<std::size_t> width;
  for (const std::string& column : catalogue.columns) width.push_back(column.size());
  for (const std::vector<CatalogueCell>& row : catalogue.rows)
    for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], row[c].text.size());
  std::string out;
  const auto line = [&](const auto& cell_text) {
    std::string words;
    for (std::size_t c = 0; c < width.size(); ++c)
      words += fmt::format("{:{}}  ", cell_text(c), width[c]);
    out += words.substr(0, words.find_last_not_of(' ') + 1) + '\n';
  };
  line([&](std::size_t c) { return catalogue.columns[c]; });
  for (const std::vector<CatalogueCell>& row : catalogue.rows)
    line([&](std::size_t c) { return row[c].text; });
  return out;
}

}  // namespace pentimento
