#pragma once
// A plane with a border of zeros, so that kernels may read one cell beyond the canvas. Row y is
// valid for y in [-1, height], x in [-16, width + 16).

#include <algorithm>

#include "core/base/field.h"
#include "core/base/give_back.h"

namespace pentimento::conservative {

class WorkPlane {
 public:
  WorkPlane() = default;
  WorkPlane(int width, int height, PlaneMemory& memory)
      : width_(width), height_(height), storage_(width + 2 * kSide, height + kEnds, memory) {}
  /// Memory for so many planes of that size.
  static PlaneMemory memory_for(int planes, int width, int height) {
    return {planes, width + 2 * kSide, height + kEnds};
  }
  int width() const { return width_; }
  int height() const { return height_; }
  float* row(int y) { return storage_.row(y + 1) + kSide; }
  const float* row(int y) const { return storage_.row(y + 1) + kSide; }
  /// Writes zeros in [x0, x1) x [y0, y1).
  void clear(int x0, int x1, int y0, int y1) {
    for (int y = y0; y < y1; ++y) std::fill(row(y) + x0, row(y) + x1, 0.0f);
  }
  /// Gives back the memory of [x0, x1) x [y0, y1), page by page, where the plane holds zeros.
  void give_back(int x0, int x1, int y0, int y1) {
    const auto bytes = [](const float* begin, const float* end) {
      return static_cast<std::size_t>(end - begin) * sizeof(float);
    };
    // Whole rows lie one behind the other, if there are zeros between them.
    if (x0 == 0 && x1 == width_ && row(y0)[-1] == 0 && row(y0)[width_] == 0)
      return pentimento::give_back(row(y0), bytes(row(y0), row(y1 - 1) + width_));
    for (int y = y0; y < y1; ++y)
      pentimento::give_back(row(y) + x0, bytes(row(y) + x0, row(y) + x1));
  }
  friend void swap(WorkPlane& a, WorkPlane& b) noexcept {
    std::swap(a.width_, b.width_);
    std::swap(a.height_, b.height_);
    swap(a.storage_, b.storage_);
  }

 private:
  static constexpr int kSide = 16;  // one cache line of floats: rows stay aligned
  static constexpr int kEnds = 2;   // rows above and below
  int width_ = 0;
  int height_ = 0;
  Field<float> storage_;
};

}  // namespace pentimento::conservative
