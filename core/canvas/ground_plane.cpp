#include "core/canvas/ground_plane.h"

#include <vector>

namespace pentimento {

Field<float> GroundPlane::values() const {
  Field<float> out(width(), height());
  for (int y = 0; y < height(); ++y) read(0, y, out.view().row_span(y));
  return out;
}

void GroundPlane::read(int x, int y, std::span<float> out) const {
  const std::uint32_t* differing = differences_.bits().row(y) + x;
  const auto ground = std::bit_cast<std::uint32_t>(ground_);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = std::bit_cast<float>(differing[i] ^ ground);
}

void GroundPlane::write(int x, int y, std::span<const float> values) {
  std::uint32_t* differing = differences_.bits().row(y) + x;
  const auto ground = std::bit_cast<std::uint32_t>(ground_);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::uint32_t now = std::bit_cast<std::uint32_t>(values[i]) ^ ground;
    if (differing[i] != now) differing[i] = now;  // a page of zeros stays one
  }
}

void GroundPlane::fill(float ground) {
  ground_ = ground;
  const std::vector<float> row(static_cast<std::size_t>(width()), ground);
  for (int y = 0; y < height(); ++y) write(0, y, row);
}

}  // namespace pentimento
