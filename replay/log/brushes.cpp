#include "replay/log/brushes.h"

#include <optional>
#include <utility>

#include "core/brush/builtin_brushes.h"
#include "core/brush/tuft.h"
#include "formats/image/read_image.h"

namespace pentimento {

namespace {
void set(const std::optional<double>& value, float& out) {
  if (value) out = static_cast<float>(*value);
}

PressureCurve make_curve(const log::BrushSpec::Curve& points) {
  PressureCurve curve;
  for (const auto& [pressure, value] : points)
    curve.points[static_cast<std::size_t>(curve.count++)] = {static_cast<float>(pressure),
                                                             static_cast<float>(value)};
  return curve;
}

/// Applies the values in which the log's brush differs from its shape.
void apply_spec(const log::BrushSpec& spec, BrushDefinition& brush) {
  set(spec.spacing, brush.spacing);
  set(spec.size_pressure, brush.size_pressure);
  set(spec.flow_pressure, brush.flow_pressure);
  if (spec.follows_direction) brush.follows_direction = *spec.follows_direction;
  set(spec.stiffness, brush.stiffness);
  set(spec.grip, brush.grip);
  set(spec.capacity, brush.capacity);
  set(spec.film, brush.film);
  set(spec.absorb, brush.absorb);
  if (spec.bristles) {
    if (brush.bristles.count == 0) brush.bristles = tuft_of(TipShape::kBristle).bristles;
    if (spec.bristles->count) brush.bristles.count = static_cast<int>(*spec.bristles->count);
    set(spec.bristles->thickness, brush.bristles.thickness);
    set(spec.bristles->length_spread, brush.bristles.length_spread);
    set(spec.bristles->clumping, brush.bristles.clumping);
  }
  brush.size = make_curve(spec.size);
  brush.flow = make_curve(spec.flow);
  brush.splay = make_curve(spec.splay);
}

Result<BrushDefinition> make_brush(const log::BrushSpec& spec, LogFiles& files) {
  BrushDefinition brush;
  if (!spec.texture.empty()) {
    Result<std::string> path = files.use(spec.texture);
    if (!path) return path.error();
    Result<Field<float>> tip = read_tip(*path);
    if (!tip) return tip.error();
    brush.shape = TipShape::kTexture;
    brush.texture = std::move(*tip);
  } else {
    std::optional<BrushDefinition> builtin = builtin_brush(spec.shape);
    if (!builtin) {
      return Error{ErrorCode::kBadInput, "brushes: no shape is called \"" + spec.shape + "\""};
    }
    brush = std::move(*builtin);
  }
  brush.name = spec.name;
  apply_spec(spec, brush);
  return brush;
}
}  // namespace
BrushTable::BrushTable() {
  for (const std::string& name : builtin_brush_names()) {
    brushes_.emplace(name, std::move(*builtin_brush(name)));
  }
}

Result<BrushTable> BrushTable::make(const log::Header& header, LogFiles& files) {
  BrushTable table;
  for (const log::BrushSpec& spec : header.brushes) {
    Result<BrushDefinition> brush = make_brush(spec, files);
    if (!brush) return brush.error();
    table.brushes_.insert_or_assign(spec.name, std::move(*brush));
  }
  return table;
}

const BrushDefinition& BrushTable::find(const std::string& name) const {
  const auto found = brushes_.find(name);
  PENTIMENTO_CHECK(found != brushes_.end());
  return found->second;
}

}  // namespace pentimento
