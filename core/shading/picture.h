#pragma once
// Pictures on their way out, as strips: whole rows in scene-linear light, from top to bottom, so
// that no stage holds the whole picture.

#include <string>
#include <vector>

#include "core/base/field.h"
#include "core/base/result.h"

namespace pentimento {

/// Named float planes of `rows` rows from row `y0` on. "R","G","B" first, then the asked AOVs
/// ("albedo.R", "normal.X", "height.Y", ... as in docs/cli.md, EXR layers).
struct PictureStrip {
  int y0 = 0;
  int rows = 0;
  std::vector<std::string> name;
  std::vector<FieldView<const float>> plane;  // same order as name; width x rows
};

class PictureSink {
 public:
  virtual ~PictureSink() = default;
  /// Takes the next strip. Strips come in order and without gaps.
  virtual Result<void> write(const PictureStrip& strip) = 0;
};

}  // namespace pentimento
