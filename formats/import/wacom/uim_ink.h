#pragma once
// What all encodings of Wacom's Universal Ink Model say alike: splines of strokes, and what sensors
// measured meanwhile. No behaviour.

#include <map>
#include <string>
#include <vector>

#include "formats/import/sketch/sketch.h"

namespace pentimento::sketch {

/// What one sensor context measured during a stroke. Lists that are not empty have one length.
struct UimSensor {
  std::vector<double> time_s, x_px, y_px, pressure, altitude_rad, azimuth_rad;
};

/// A stroke as it is drawn; it has points. Places in px, y down.
struct UimStroke {
  std::vector<double> x, y, size;  // of spline points; size may be empty
  double common_size = 0;          // of all points; 0: none
  log::Rgb color = {0, 0, 0};      // linear light
  double opacity = 1;
  BrushKind brush = BrushKind::kRound;
  bool erases = false;
  std::string sensor;  // key of UimInk::sensors; may be missing there
};

struct UimInk {
  std::vector<UimStroke> strokes;
  int empty_strokes = 0;  // without points
  std::map<std::string, UimSensor> sensors;
};

}  // namespace pentimento::sketch
