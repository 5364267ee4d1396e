#pragma once
// Files of Tilt Brush as tests write them, value by value.

#include <cstdint>
#include <cstring>
#include <string>

namespace pentimento::sketch {

/// The bytes of a data.sketch.
class TiltBytes {
 public:
  template <typename T>
  TiltBytes& value(T v) {
    char raw[sizeof(T)];
    std::memcpy(raw, &v, sizeof(T));
    bytes_.append(raw, sizeof(T));
    return *this;
  }
  TiltBytes& head(std::int32_t strokes, std::int32_t version = 5) {
    return value(0xC576A5CDu)
        .value(version)
        .value(0)
        .value(3u)
        .value('a')
        .value('b')
        .value('c')
        .value(strokes);
  }
  /// Up to the masks.
  TiltBytes& stroke(std::int32_t brush, float red, float size) {
    value(brush).value(red).value(0.0f).value(1.0f).value(1.0f);
    return value(size);
  }
  TiltBytes& place(float x, float y, float z) {
    for (const float v : {x, y, z, 0.0f, 0.0f, 0.0f, 1.0f}) value(v);
    return *this;
  }
  TiltBytes& point(float x, float y, float z, float pressure, std::uint32_t ms) {
    return place(x, y, z).value(pressure).value(ms);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

}  // namespace pentimento::sketch
