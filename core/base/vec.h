#pragma once
// Small vectors in core's frame: x to the right, y DOWN the canvas (row order), z out of the canvas
// towards the viewer. In logs and dumps, y points up for sensors and velocities; the code in
// formats converts.

namespace pentimento {

struct Vec2f {
  float x = 0, y = 0;
  friend bool operator==(const Vec2f&, const Vec2f&) = default;
};
struct Vec3f {
  float x = 0, y = 0, z = 0;
};

}  // namespace pentimento
