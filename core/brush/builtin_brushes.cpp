#include "core/brush/builtin_brushes.h"

#include <array>

#include "core/brush/tuft.h"

namespace pentimento {

namespace {
struct Builtin {
  std::string_view name;
  TipShape shape;
  float size_pressure;  // soft bristle spreads under pressure, a blade does not
  float flow_pressure;
  float spacing;   // 0: the slider's; a thin blade prints ribs at 2.5 %
  float capacity;  // in diameters; long bristle holds more paint (docs/brushes.md)
};

constexpr std::array<Builtin, 8> kBuiltins = {{{"round", TipShape::kRound, 0.4f, 0.7f, 0, 400},
                                               {"flat", TipShape::kFlat, 0.12f, 0.7f, 0, 400},
                                               {"filbert", TipShape::kFilbert, 0.25f, 0.7f, 0, 400},
                                               {"bristle", TipShape::kBristle, 0.2f, 0.7f, 0, 240},
                                               {"fan", TipShape::kFan, 0.1f, 0.6f, 0.0125f, 120},
                                               {"rigger", TipShape::kRigger, 0.5f, 0.5f, 0, 1000},
                                               {"knife", TipShape::kKnife, 0, 0.5f, 0.0125f, 200},
                                               {"rag", TipShape::kRag, 0.2f, 1, 0.05f, 200}}};
}  // namespace

std::optional<BrushDefinition> builtin_brush(std::string_view name) {
  for (const Builtin& b : kBuiltins) {
    if (b.name != name) continue;
    BrushDefinition brush;
    brush.name = std::string(b.name);
    brush.shape = b.shape;
    brush.size_pressure = b.size_pressure;
    brush.flow_pressure = b.flow_pressure;
    brush.spacing = b.spacing;
    brush.capacity = b.capacity;
    brush.follows_direction = b.shape != TipShape::kRag;  // alike from all sides, or nearly
    if (b.shape == TipShape::kKnife) {
      brush.scrapes = true;
    } else if (b.shape == TipShape::kRag) {
      brush.film = 0;
      brush.absorb = 0.99f;
    } else {
      brush.bristles = tuft_of(b.shape).bristles;
    }
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
