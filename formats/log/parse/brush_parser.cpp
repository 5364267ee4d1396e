#include "formats/log/parse/brush_parser.h"

#include <fmt/format.h>

#include "core/brush/pressure_curve.h"
#include "formats/log/tables/ranges.h"

namespace pentimento::log {

namespace {
constexpr std::string_view kShapes[] = {"round", "flat",   "filbert", "bristle",
                                        "fan",   "rigger", "knife",   "rag"};

BrushSpec::Bristles parse_bristles(Fields& brush, const JsonNode& node) {
  const std::string prefix = fmt::format("{}bristles.", brush.prefix());
  Fields fields(brush.line(), node, prefix);
  BrushSpec::Bristles bristles;
  if (const auto count = fields.whole("count", kBristleCountRange))
    bristles.count = static_cast<double>(*count);
  bristles.thickness = fields.number("thickness", kBristleThicknessRange);
  bristles.length_spread = fields.number("length_spread", kUnitRange);
  bristles.clumping = fields.number("clumping", kUnitRange);
  brush.fail_unless_empty(fields.finish());
  return bristles;
}

/// [[pressure, value], ...], pressures rising.
BrushSpec::Curve parse_curve(Fields& fields, std::string_view name, const Range& value) {
  if (!fields.has(name)) return {};
  const std::vector<const JsonNode*> points = fields.elements(name);
  BrushSpec::Curve curve;
  if (points.empty() || points.size() > static_cast<std::size_t>(kMostCurvePoints)) {
    fields.fail(fmt::format("{}{} has {} points, outside 1..{}", fields.prefix(), name,
                            points.size(), kMostCurvePoints));
  }
  for (std::size_t i = 0; i < points.size() && fields.ok(); ++i) {
    std::array<double, 2> point{};
    fields.read_pair(*points[i], fmt::format("{}[{}]", name, i), {kUnitRange, value}, point);
    if (fields.ok() && i > 0 && !(point[0] > curve.back()[0])) {
      fields.fail(fmt::format("{}{}[{}] pressure {} is not above the one before", fields.prefix(),
                              name, i, point[0]));
    }
    curve.push_back(point);
  }
  return curve;
}

void parse_pressure(Fields& brush, const JsonNode& node, BrushSpec& spec) {
  const std::string prefix = fmt::format("{}pressure.", brush.prefix());
  Fields fields(brush.line(), node, prefix);
  spec.size = parse_curve(fields, "size", kPressureFactorRange);
  spec.flow = parse_curve(fields, "flow", kPressureFactorRange);
  spec.splay = parse_curve(fields, "splay", kUnitRange);
  brush.fail_unless_empty(fields.finish());
}
}  // namespace

BrushSpec parse_brush_spec(Fields& fields) {
  BrushSpec brush;
  brush.name = fields.required("name", fields.text("name"));
  if (fields.ok() && brush.name.empty()) fields.reject("name", "is empty");
  const std::optional<int> shape = fields.choice("shape", kShapes);
  const std::optional<std::string> texture = fields.text("texture");
  if (shape.has_value() == texture.has_value()) {
    fields.fail(
        fmt::format("{}name \"{}\" needs either shape or texture", fields.prefix(), brush.name));
  }
  if (shape) brush.shape = kShapes[static_cast<std::size_t>(*shape)];
  brush.texture = texture.value_or("");
  brush.spacing = fields.number("spacing", kSpacingRange);
  brush.size_pressure = fields.number("size_pressure", kUnitRange);
  brush.flow_pressure = fields.number("flow_pressure", kUnitRange);
  brush.follows_direction = fields.flag("follows_direction");
  brush.stiffness = fields.number("stiffness", kUnitRange);
  brush.grip = fields.number("grip", kUnitRange);
  brush.capacity = fields.number("capacity", kCapacityRange);
  brush.film = fields.number("film", kUnitRange);
  brush.absorb = fields.number("absorb", kUnitRange);
  if (const JsonNode* node = fields.object("bristles")) {
    brush.bristles = parse_bristles(fields, *node);
    if (brush.shape == "knife" || brush.shape == "rag")
      fields.fail(fmt::format("{}bristles: a {} has none", fields.prefix(), brush.shape));
  }
  if (const JsonNode* node = fields.object("pressure")) parse_pressure(fields, *node, brush);
  return brush;
}

}  // namespace pentimento::log
