#pragma once
// Memory for many planes at once: one mapping, for which the system is asked for large pages. A
// page is given when it is first written to, and giving one takes far longer than filling it where
// the machine is a virtual one; planes that are written to all over take a five-hundredth of these
// faults from here.

#include <cstddef>
#include <memory>

namespace pentimento {

class PlaneMemory {
 public:
  /// Memory that gives nothing.
  PlaneMemory() = default;
  /// Room for `planes` planes of `width` x `height` values of four bytes. Gives nothing where that
  /// is too little for large pages, where a plane is so large that a large page would be little of
  /// it, or where the system has none.
  PlaneMemory(int planes, int width, int height);
  /// Whether planes of this size are too large for it. They then take memory page by page, where
  /// they are written to.
  static bool leaves_out(int width, int height);

  /// Zeros for `bytes` bytes from a cache line on, or nullptr if no room is left. They stay as long
  /// as anybody keeps mapping().
  void* take(std::size_t bytes);
  const std::shared_ptr<void>& mapping() const { return mapping_; }

 private:
  std::shared_ptr<void> mapping_;
  unsigned char* free_ = nullptr;
  std::size_t left_bytes_ = 0;
};

}  // namespace pentimento
