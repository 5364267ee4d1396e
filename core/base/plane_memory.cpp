#include "core/base/plane_memory.h"

#include <sys/mman.h>

#include <cstdint>

namespace pentimento {

namespace {
constexpr std::size_t kLargePage_bytes = std::size_t{2} << 20;
constexpr std::size_t kLine_bytes = 64;
// Planes whose lines lay as many pages apart as a cache has would push each other out of it.
constexpr std::size_t kStagger_bytes = 4096 + kLine_bytes;
constexpr std::size_t kLeast_bytes = 4 * kLargePage_bytes;  // less is as quick from the heap
// A painting that covers little of a plane this large takes many times its size in large pages.
constexpr std::size_t kLargestPlane_bytes = std::size_t{16} << 20;

std::size_t rounded_up(std::size_t bytes, std::size_t to) {
  return (bytes + to - 1) / to * to;
}
std::size_t room_of(std::size_t plane_bytes) {
  return rounded_up(plane_bytes, kLine_bytes) + kStagger_bytes;
}

// The address sanitizer finds what runs over from plane to plane only if each has memory of its
// own. gcc and clang tell of it in different ways.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool kFindsOverflows = true;
#elif defined(__has_feature)
constexpr bool kFindsOverflows = __has_feature(address_sanitizer);
#else
constexpr bool kFindsOverflows = false;
#endif

std::size_t plane_bytes(int width, int height) {
  return rounded_up(static_cast<std::size_t>(width) * 4, kLine_bytes) *
         static_cast<std::size_t>(height);
}
}  // namespace

bool PlaneMemory::leaves_out(int width, int height) {
  return plane_bytes(width, height) > kLargestPlane_bytes;
}

PlaneMemory::PlaneMemory(int planes, int width, int height) {
  const std::size_t plane = plane_bytes(width, height);
  const std::size_t bytes =
      rounded_up(static_cast<std::size_t>(planes) * room_of(plane), kLargePage_bytes);
  if (kFindsOverflows || leaves_out(width, height) || bytes < kLeast_bytes) return;
  // Large pages begin at multiples of their size.
  const std::size_t mapped = bytes + kLargePage_bytes;
  void* const begin = mmap(nullptr, mapped, PROT_READ | PROT_WRITE,
                           MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (begin == MAP_FAILED) return;
  mapping_ = std::shared_ptr<void>(begin, [mapped](void* p) { munmap(p, mapped); });
  free_ = static_cast<unsigned char*>(begin);
  left_bytes_ = mapped;
  void* first = begin;
  if (std::align(kLargePage_bytes, bytes, first, left_bytes_) == nullptr) return;
  free_ = static_cast<unsigned char*>(first);
  left_bytes_ = bytes;
  madvise(first, bytes, MADV_HUGEPAGE);  // a system without them gives small ones
}

void* PlaneMemory::take(std::size_t bytes) {
  const std::size_t room = room_of(bytes);
  if (room > left_bytes_) return nullptr;
  void* const plane = free_;
  free_ += room;
  left_bytes_ -= room;
  return plane;
}

}  // namespace pentimento
