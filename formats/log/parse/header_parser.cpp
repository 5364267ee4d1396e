#include "formats/log/parse/header_parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/optics/spectral/measured_paints.h"
#include "formats/log/parse/fields.h"
#include "formats/log/parse/palette_parser.h"
#include "formats/log/tables/model_fields.h"
#include "formats/log/tables/ranges.h"

namespace pentimento::log {

namespace {

constexpr std::string_view kEdges[] = {"closed", "open"};
constexpr std::string_view kOptics[] = {"rgb", "spectral"};
constexpr std::string_view kToneCurves[] = {"none", "soft", "filmic"};  // in the order of ToneCurve

/// Checks that this is a log of a version that we know. This comes first, for in a newer version
/// everything else may differ.
void parse_identity(Fields& fields, Header& header) {
  if (fields.text_view("type") != "header") {
    fields.fail("line 1 is not a header: its type is not \"header\"");
  }
  const std::string_view format = fields.required("format", fields.text_view("format"));
  if (format != "pentimento-log") fields.reject("format", "is not \"pentimento-log\"");
  const std::int64_t version =
      fields.required("version", fields.whole("version", {1, kMaxExactInteger}));
  if (version > kLogVersion) {
    fields.fail(fmt::format("version {} is newer than {}, the newest known", version, kLogVersion));
  }
  header.version = static_cast<int>(std::min<std::int64_t>(version, kLogVersion));
}

void parse_canvas(Fields& header_fields, Header& header) {
  const JsonNode* node = header_fields.object("canvas");
  if (node == nullptr) return header_fields.missing("canvas");
  Fields fields(header_fields.line(), *node, "canvas.");
  header.canvas_width_m = fields.required("width", fields.number("width", kCanvasRange));
  header.canvas_height_m = fields.required("height", fields.number("height", kCanvasRange));
  header.edge_open = fields.choice("edge", kEdges).value_or(0) == 1;
  header_fields.fail_unless_empty(fields.finish());
}

/// Without `grid`: 1024 cells along the longer side, square cells.
void default_grid(Header& header) {
  constexpr double kLongerSide = 1024;
  const double width = header.canvas_width_m, height = header.canvas_height_m;
  const double cells_per_m = kLongerSide / std::max(width, height);
  header.grid_width = std::max(1, static_cast<int>(std::lround(width * cells_per_m)));
  header.grid_height = std::max(1, static_cast<int>(std::lround(height * cells_per_m)));
}

void parse_grid(Fields& header_fields, Header& header) {
  const JsonNode* node = header_fields.object("grid");
  if (node == nullptr) return default_grid(header);
  Fields fields(header_fields.line(), *node, "grid.");
  header.grid_width = static_cast<int>(fields.required("width", fields.whole("width", kGridRange)));
  header.grid_height =
      static_cast<int>(fields.required("height", fields.whole("height", kGridRange)));
  header_fields.fail_unless_empty(fields.finish());
}

void parse_paper(Fields& header_fields, PaperSpec& paper) {
  const JsonNode* node = header_fields.object("paper");
  if (node == nullptr) return;
  Fields fields(header_fields.line(), *node, "paper.");
  paper.texture = fields.text("texture").value_or(paper.texture);
  if (paper.texture.empty()) fields.reject("texture", "is empty");
  paper.relief_m = fields.number("relief", kReliefRange).value_or(paper.relief_m);
  paper.scale_m = fields.number("scale", kTextureScaleRange).value_or(paper.scale_m);
  paper.reflectance = fields.color("reflectance").value_or(paper.reflectance);
  header_fields.fail_unless_empty(fields.finish());
}

/// Spectral paint is seen through the interface of the measured paints, unless the model says else.
void parse_optics(Fields& header_fields, Model& model) {
  if (header_fields.choice("optics", kOptics).value_or(0) == 0) return;
  model.optics = OpticsKind::kSpectral;
  model.saunderson_k2 = static_cast<float>(kMeasuredK2);
}

void parse_model(Fields& header_fields, Model& model) {
  const JsonNode* node = header_fields.object("model");
  if (node == nullptr) return;
  Fields fields(header_fields.line(), *node, "model.");
  for (const ModelField& field : model_fields()) {
    const std::optional<double> value = fields.parameter(field, field.name);
    if (value) set_model_value(field, model, *value);
  }
  header_fields.fail_unless_empty(fields.finish());
  const std::string problem = model_problem(model);
  if (!problem.empty()) header_fields.fail("model." + problem);
}

void parse_picture(Fields& header_fields, PictureSpec& picture) {
  const JsonNode* node = header_fields.object("picture");
  if (node == nullptr) return;
  Fields fields(header_fields.line(), *node, "picture.");
  picture.exposure_ev = fields.number("exposure", kExposureRange);
  picture.varnish = fields.number("varnish", kUnitRange);
  picture.occlusion = fields.number("occlusion", kUnitRange);
  picture.white_temperature_K = fields.number("white_temperature", kTemperatureRange);
  if (const auto xy = fields.numbers("white_point", kChromaticityRange)) {
    if (xy->size() != 2) fields.reject("white_point", "is not two numbers, x and y");
    if (xy->size() == 2) picture.white_xy = {(*xy)[0], (*xy)[1]};
  }
  if (picture.white_xy && picture.white_temperature_K) {
    fields.fail("picture has both white_point and white_temperature");
  }
  if (const auto curve = fields.choice("tone_curve", kToneCurves)) {
    picture.tone = static_cast<ToneCurve>(*curve);
  }
  header_fields.fail_unless_empty(fields.finish());
}

}  // namespace

std::string parse_header(const JsonLine& json, Header& header) {
  Fields fields(json, json.nodes()[0]);
  parse_identity(fields, header);
  if (!fields.ok()) return fields.problem();
  parse_canvas(fields, header);
  if (!fields.ok()) return fields.problem();
  parse_grid(fields, header);
  header.steps_per_second =
      fields.number("steps_per_second", kStepsPerSecondRange).value_or(header.steps_per_second);
  parse_paper(fields, header.paper);
  header.palette = parse_palette(fields);
  header.brushes = parse_brushes(fields);
  parse_optics(fields, header.model);
  parse_model(fields, header.model);
  parse_picture(fields, header.picture);
  header.title = fields.text("title").value_or("");
  header.author = fields.text("author").value_or("");
  header.recorded_by = fields.text("recorded_by").value_or("");
  header.recorded_at = fields.text("recorded_at").value_or("");
  std::string problem = fields.finish();
  header.extensions = fields.extensions();
  return problem;
}

}  // namespace pentimento::log
