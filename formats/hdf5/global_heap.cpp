#include "formats/hdf5/global_heap.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace pentimento::hdf5 {

namespace {

constexpr std::string_view kSignature = "GCOL";
constexpr std::size_t kSizeAt = 8;         // of the heap's own size
constexpr std::size_t kHeaderBytes = 16;   // before the first object
constexpr std::size_t kObjectHeader = 16;  // number, references, four bytes of nothing, size
constexpr std::size_t kObjectSizeAt = 8;
constexpr std::uint64_t kAlignment = 8;

/// Little endian, of `count` bytes.
std::uint64_t number_at(std::span<const std::byte> bytes, std::size_t at, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t i = count; i-- > 0;)
    value = value << 8 | std::to_integer<std::uint8_t>(bytes[at + i]);
  return value;
}

/// Object 0 is free room and counts its header; the others do not, and are padded.
std::uint64_t room_taken(std::uint64_t number, std::uint64_t size) {
  if (number == 0) return size;
  return kObjectHeader + (size + kAlignment - 1) / kAlignment * kAlignment;
}

}  // namespace

bool is_endless_heap(std::span<const std::byte> bytes) {
  if (bytes.size() < kHeaderBytes ||
      std::memcmp(bytes.data(), kSignature.data(), kSignature.size()) != 0)
    return false;
  const std::uint64_t heap_bytes = number_at(bytes, kSizeAt, 8);
  const std::uint64_t end = std::min<std::uint64_t>(heap_bytes, bytes.size());
  std::uint64_t at = kHeaderBytes;
  // What is left after the last object may be too small for a header; the library takes it as free.
  while (at <= end && end - at >= kObjectHeader) {
    const std::uint64_t left = heap_bytes - at;
    const std::uint64_t size = number_at(bytes, at + kObjectSizeAt, 8);
    if (size > left) return true;
    const std::uint64_t taken = room_taken(number_at(bytes, at, 2), size);
    if (taken == 0 || taken > left) return true;
    at += taken;
  }
  return false;
}

}  // namespace pentimento::hdf5
