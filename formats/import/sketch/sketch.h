#pragma once
// A drawing as another program recorded it: what every reader of this folder brings, before it
// becomes an action log (formats/import/sketch/sketch_log.h). No behaviour.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "formats/log/tables/events.h"

namespace pentimento::sketch {

/// One sample of a pen. Places and widths in the source's unit, x right, y down.
struct Sample {
  double x = 0, y = 0;
  double time_s = 0;     // from any moment that is the same for the whole drawing
  float pressure = 0;    // 0..1
  float tilt_x_deg = 0;  // as in the action log: positive leans to the right,
  float tilt_y_deg = 0;  // ... and towards the painter; -90..90
  float twist_deg = 0;   // -360..360
};

/// The nearest built-in brush; round and rigger are pens, which do not run dry.
enum class BrushKind { kRound, kFlat, kBristle, kRigger };

struct Stroke {
  std::vector<Sample> samples;  // at least one; times do not run back
  bool timed = false;           // the samples' times are the source's
  bool has_pressure = false, has_tilt = false, has_twist = false;
  double width = 0;  // at full pressure; 0: the source does not say
  /// Of the width, at no pressure; none: the brush's own.
  std::optional<double> width_share_unpressed = {};
  log::Rgb color = {0, 0, 0};  // linear light
  double opacity = 1;          // 0..1
  BrushKind brush = BrushKind::kRound;
  bool erases = false;
  int layer = 0;  // strokes of lower layers lie below, whenever they were drawn
};

/// What is not a stroke. It happens after the items before it.
enum class SketchAction { kDry, kClear, kUndo, kRedo };

using Item = std::variant<Stroke, SketchAction>;

/// The part of the plane that is paper.
struct Page {
  double x = 0, y = 0, width = 0, height = 0;
};

/// What became of the source's properties, for people: "pressure", "tilt from the azimuth",
/// "3 erased strokes". In the order of mention.
struct Report {
  std::vector<std::string> kept, guessed, dropped;
  /// What the file holds, where the sketch has less or parts it otherwise; 0: as many.
  std::int64_t file_strokes = 0, file_samples = 0;
};

struct Sketch {
  std::vector<Item> items;               // in the order of painting
  std::optional<Page> page;              // none: the bounds of the strokes
  std::optional<double> metre_per_unit;  // none: the drawing is made a metre wide
  std::optional<log::Rgb> paper;         // linear light of the ground
  std::string title, author, recorded_by, recorded_at;
  Report report;
};

}  // namespace pentimento::sketch
