#include "formats/image/orientation.h"

#include <utility>

namespace pentimento::image {

Field<float> upright(Field<float> stored, int orientation) {
  if (orientation < 2 || orientation > 8) return stored;
  const bool turned = orientation >= 5;
  // Of what is stored: whether its columns run from right to left, and its rows from below upwards.
  const bool from_right =
      orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
  const bool from_below =
      orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
  const int width = stored.width(), height = stored.height();
  Field<float> seen(turned ? height : width, turned ? width : height);
  for (int y = 0; y < height; ++y) {
    const float* row = stored.row(y);
    const int down = from_below ? height - 1 - y : y;
    for (int x = 0; x < width; ++x) {
      const int along = from_right ? width - 1 - x : x;
      (turned ? seen(down, along) : seen(along, down)) = row[x];
    }
  }
  return seen;
}

}  // namespace pentimento::image
