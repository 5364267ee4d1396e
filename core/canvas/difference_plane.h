#pragma once
// A plane of values that are mostly known from elsewhere. It keeps the bits in which a value
// differs from the known one. These are 0 nearly everywhere, and a large plane of zeros takes no
// memory.

#include <bit>
#include <cstdint>
#include <span>

#include "core/base/field.h"

namespace pentimento {

class DifferencePlane {
 public:
  /// Has no cells.
  DifferencePlane() = default;
  /// All values are the known ones.
  DifferencePlane(int width, int height) : bits_(width, height) {}
  /// The same in memory that the planes around it share.
  DifferencePlane(int width, int height, PlaneMemory& memory) : bits_(width, height, memory) {}

  int width() const { return bits_.width(); }
  int height() const { return bits_.height(); }
  bool empty() const { return bits_.empty(); }
  DifferencePlane clone() const;
  /// The bits themselves, for storing and hashing.
  Field<std::uint32_t>& bits() { return bits_; }
  const Field<std::uint32_t>& bits() const { return bits_; }

  /// The value of a cell whose known value is `known`. Any bits come back as they were, those of
  /// -0 and of NaN too.
  float at(int x, int y, float known) const {
    return std::bit_cast<float>(bits_(x, y) ^ std::bit_cast<std::uint32_t>(known));
  }
  void set(int x, int y, float known, float value) {
    bits_(x, y) = std::bit_cast<std::uint32_t>(known) ^ std::bit_cast<std::uint32_t>(value);
  }
  /// The cells x .. x + out.size() - 1 of row y, whose known values `known` has.
  void read(int x, int y, std::span<const float> known, std::span<float> out) const;
  /// Writes where the bits change.
  void write(int x, int y, std::span<const float> known, std::span<const float> values);

 private:
  Field<std::uint32_t> bits_;
};

}  // namespace pentimento
