#pragma once
// The bytes of a part of a slot: plain values one after the other, little-endian, without gaps. The
// writer and the reader of a part call the same functions in the same order.

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pentimento::checkpoint {

static_assert(std::endian::native == std::endian::little);

class ArchiveWriter {
 public:
  void flag(bool v) { put<std::uint8_t>(v ? 1 : 0); }
  void u32(std::uint32_t v) { put(v); }
  void u64(std::uint64_t v) { put(v); }
  void i32(std::int32_t v) { put(v); }
  void i64(std::int64_t v) { put(v); }
  void f32(float v) { put(v); }
  void f64(double v) { put(v); }
  /// The length, then the bytes.
  void text(std::string_view v);
  /// The count, then the values.
  template <typename T>
  void list(std::span<const T> values) {
    u64(values.size());
    raw(values);
  }
  /// Values whose count the reader knows.
  template <typename T>
  void raw(std::span<const T> values) {
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  }

  const std::string& bytes() const { return bytes_; }
  std::string take() { return std::move(bytes_); }

 private:
  template <typename T>
  void put(T value) {
    raw(std::span<const T>(&value, 1));
  }
  std::string bytes_;
};

/// Never leaves its bytes. The first problem is kept: after it every value is 0 and every list is
/// empty, so that loops end. A list is given memory only for values that are there.
class ArchiveReader {
 public:
  /// `bytes` must outlive the reader.
  explicit ArchiveReader(std::string_view bytes) : bytes_(bytes) {}

  bool flag();
  std::uint32_t u32() { return take<std::uint32_t>(); }
  std::uint64_t u64() { return take<std::uint64_t>(); }
  std::int32_t i32() { return take<std::int32_t>(); }
  std::int64_t i64() { return take<std::int64_t>(); }
  /// These fail unless the number is finite.
  float f32();
  double f64();
  std::string text();
  /// How many records follow, each at least `record_bytes` long. Fails if they cannot all be there.
  std::uint64_t count(std::size_t record_bytes);
  template <typename T>
  std::vector<T> list() {
    std::vector<T> values(static_cast<std::size_t>(count(sizeof(T))));
    raw(std::span<T>(values));
    return values;
  }
  /// Fills `out`; with zeros after a problem. Fails unless floating numbers are finite.
  template <typename T>
  void raw(std::span<T> out) {
    fill(out.data(), out.size_bytes());
    if constexpr (std::is_floating_point_v<T>) check_finite(out);
  }

  /// Keeps the problem unless there is one already.
  void fail(std::string_view problem);
  bool ok() const { return problem_.empty(); }
  /// Ok, and nothing is left.
  bool complete();
  const std::string& problem() const { return problem_; }

 private:
  template <typename T>
  T take() {
    T value{};
    fill(&value, sizeof(T));
    return value;
  }
  void fill(void* out, std::size_t count);
  void check_finite(std::span<const float> values);
  void check_finite(std::span<const double> values);

  std::string_view bytes_;
  std::size_t at_ = 0;
  std::string problem_;
};

}  // namespace pentimento::checkpoint
