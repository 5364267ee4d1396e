#pragma once
// The recordings of other programs that can be read: which there are, and which one a file is. The
// content decides, not the name.

#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "formats/import/sketch/sketch.h"

namespace pentimento::sketch {

/// From where a 3-D sketch is seen.
enum class View {
  kCamera,  // as its own thumbnail camera saw it; the plane where it has none
  kPlane,   // onto the plane that fits it best
  kFront    // along its z axis
};

/// Which column of a table is what; "" is not there. Names of a header, or numbers from 1.
struct CsvColumns {
  std::string x = "x", y = "y", time, pressure, tilt_x, tilt_y, altitude, azimuth, twist, stroke,
              pen, width, color, red, green, blue;
  double metre_per_unit = 0;  // 0: the drawing is made a metre wide
  double second_per_unit = 1;
  bool y_up = false;
};

struct ReadOptions {
  View view = View::kCamera;
  CsvColumns csv;
};

/// The content of a file. `name` is for messages.
struct Source {
  std::string name;
  std::string_view bytes;
};

/// One format. `reads` tells it from its first bytes and never fails; `read` errors: kBadInput
/// "file: where: what", kLimit.
struct Format {
  std::string_view name;        // for --as
  std::string_view title;       // for people
  std::string_view extensions;  // ".tilt"
  bool (*is)(std::string_view bytes);
  Result<Sketch> (*read)(const Source& source, const ReadOptions& options);
};

/// All formats, those that are told most surely first.
std::span<const Format> formats();

/// The format of a name; nullptr if there is none.
const Format* find_format(std::string_view name);

/// The format that the content has; nullptr if none knows it.
const Format* format_of(std::string_view bytes);

}  // namespace pentimento::sketch
