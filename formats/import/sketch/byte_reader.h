#pragma once
// Reads binary records from memory, little-endian, without ever leaving it. The first problem is
// kept: after it, every value is 0 and every count is 0, so that loops end.

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace pentimento::sketch {

class ByteReader {
 public:
  /// `base` is the offset of the first byte in the file, for messages.
  ByteReader(std::string name, std::string_view bytes, std::size_t base = 0)
      : name_(std::move(name)), bytes_(bytes), base_(base) {}

  std::uint8_t u8(std::string_view field) { return take<std::uint8_t>(field); }
  std::uint16_t u16(std::string_view field) { return take<std::uint16_t>(field); }
  std::uint32_t u32(std::string_view field) { return take<std::uint32_t>(field); }
  std::int32_t i32(std::string_view field) { return take<std::int32_t>(field); }
  std::uint64_t u64(std::string_view field) { return take<std::uint64_t>(field); }
  /// Fails unless the number is finite.
  float f32(std::string_view field);
  double f64(std::string_view field);
  std::string_view bytes(std::size_t count, std::string_view field);
  void skip(std::size_t count, std::string_view field) { bytes(count, field); }

  /// How many records follow, each at least `record_bytes` long. Fails if they cannot all be there.
  std::uint32_t count(std::string_view field, std::size_t record_bytes);

  const std::string& name() const { return name_; }
  std::size_t left() const { return bytes_.size() - at_; }
  std::size_t offset() const { return base_ + at_; }
  bool ok() const { return problem_.empty(); }
  /// Keeps "file: offset N: PROBLEM" unless there is a problem already.
  void fail(std::string problem);
  /// Keeps the problem of a reader of a part, if it has one.
  void adopt(const ByteReader& part) {
    if (ok()) problem_ = part.problem_;
  }
  /// The problem; ok() must be false.
  Error error() const { return {ErrorCode::kBadInput, problem_}; }

 private:
  template <typename T>
  T take(std::string_view field) {
    T value{};
    const std::string_view from = bytes(sizeof(T), field);
    static_assert(std::endian::native == std::endian::little);
    if (from.size() == sizeof(T)) std::memcpy(&value, from.data(), sizeof(T));
    return value;
  }

  std::string name_;
  std::string_view bytes_;
  std::size_t base_ = 0, at_ = 0;
  std::string problem_;
};

}  // namespace pentimento::sketch
