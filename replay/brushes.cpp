#include "replay/brushes.h"

#include <optional>
#include <utility>

#include "core/brush/builtin_brushes.h"
#include "formats/image/read_image.h"

namespace pentimento {

namespace {
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
  if (spec.spacing) brush.spacing = static_cast<float>(*spec.spacing);
  if (spec.size_pressure) brush.size_pressure = static_cast<float>(*spec.size_pressure);
  if (spec.flow_pressure) brush.flow_pressure = static_cast<float>(*spec.flow_pressure);
  if (spec.follows_direction) brush.follows_direction = *spec.follows_direction;
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
