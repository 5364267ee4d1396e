#include "core/canvas/difference_plane.h"

#include <utility>

namespace pentimento {

DifferencePlane DifferencePlane::clone() const {
  DifferencePlane copy;
  copy.bits_ = bits_.clone();
  return copy;
}

void DifferencePlane::read(int x, int y, std::span<const float> known, std::span<float> out) const {
  PENTIMENTO_CHECK(known.size() == out.size());
  const std::uint32_t* bits = bits_.row(y) + x;
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = std::bit_cast<float>(bits[i] ^ std::bit_cast<std::uint32_t>(known[i]));
}

void DifferencePlane::write(int x, int y, std::span<const float> known,
                            std::span<const float> values) {
  PENTIMENTO_CHECK(known.size() == values.size());
  std::uint32_t* bits = bits_.row(y) + x;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::uint32_t differing =
        std::bit_cast<std::uint32_t>(known[i]) ^ std::bit_cast<std::uint32_t>(values[i]);
    if (bits[i] != differing) bits[i] = differing;  // a page of zeros stays one
  }
}

}  // namespace pentimento
