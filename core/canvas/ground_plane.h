#pragma once
// The reflectance of the dry layer in one band: that of the ground but where something has dried or
// a picture was loaded. A large plane takes memory only there.

#include <span>

#include "core/canvas/difference_plane.h"

namespace pentimento {

class GroundPlane {
 public:
  /// Has no cells.
  GroundPlane() = default;
  /// All cells are `ground`, linear reflectance in [0,1].
  GroundPlane(int width, int height, float ground) : ground_(ground), differences_(width, height) {}
  /// The same in memory that the planes around it share.
  GroundPlane(int width, int height, float ground, PlaneMemory& memory)
      : ground_(ground), differences_(width, height, memory) {}
  /// Values `differences` over that ground.
  GroundPlane(float ground, DifferencePlane differences)
      : ground_(ground), differences_(std::move(differences)) {}

  int width() const { return differences_.width(); }
  int height() const { return differences_.height(); }
  bool empty() const { return differences_.empty(); }
  float ground() const { return ground_; }
  const DifferencePlane& differences() const { return differences_; }
  GroundPlane clone() const { return {ground_, differences_.clone()}; }
  /// All values, in a plane of their own.
  Field<float> values() const;

  float operator()(int x, int y) const { return differences_.at(x, y, ground_); }
  void set(int x, int y, float value) { differences_.set(x, y, ground_, value); }
  /// The cells x .. x + out.size() - 1 of row y.
  void read(int x, int y, std::span<float> out) const;
  void write(int x, int y, std::span<const float> values);
  /// All cells are `ground` from now on.
  void fill(float ground);

 private:
  float ground_ = 0;
  DifferencePlane differences_;
};

}  // namespace pentimento
