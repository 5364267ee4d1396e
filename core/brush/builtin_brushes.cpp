#include "core/brush/builtin_brushes.h"

#include <array>

namespace pentimento {

namespace {
struct Builtin {
  std::string_view name;
  TipShape shape;
  float size_pressure;     // soft hair spreads under pressure, a blade does not
  float spacing;           // 0: the slider's; a thin blade prints ribs at 2.5 %
  bool follows_direction;  // whatever is not the same from all sides turns with the stroke
};

constexpr std::array<Builtin, 5> kBuiltins = {{{"round", TipShape::kRound, 0.5f, 0, true},
                                               {"flat", TipShape::kFlat, 0.15f, 0, true},
                                               {"filbert", TipShape::kFilbert, 0.35f, 0, true},
                                               {"bristle", TipShape::kBristle, 0.25f, 0, true},
                                               {"knife", TipShape::kKnife, 0.0f, 0.0125f, true}}};
}  // namespace

std::optional<BrushDefinition> builtin_brush(std::string_view name) {
  for (const Builtin& b : kBuiltins) {
    if (b.name != name) continue;
    BrushDefinition brush;
    brush.name = std::string(b.name);
    brush.shape = b.shape;
    brush.size_pressure = b.size_pressure;
    brush.spacing = b.spacing;
    brush.follows_direction = b.follows_direction;
    return brush;
  }
  return std::nullopt;
}

std::vector<std::string> builtin_brush_names() {
  std::vector<std::string> names;
  for (const Builtin& b : kBuiltins) names.emplace_back(b.name);
  return names;
}

}  // namespace pentimento
