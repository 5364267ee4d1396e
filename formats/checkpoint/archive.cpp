#include "formats/checkpoint/archive.h"

#include <algorithm>
#include <cmath>

namespace pentimento::checkpoint {

void ArchiveWriter::text(std::string_view v) {
  list(std::span<const char>(v.data(), v.size()));
}

bool ArchiveReader::flag() {
  const auto value = take<std::uint8_t>();
  if (value > 1) fail("a flag is neither 0 nor 1");
  return value == 1;
}

float ArchiveReader::f32() {
  float value = 0;
  raw(std::span<float>(&value, 1));
  return value;
}

double ArchiveReader::f64() {
  double value = 0;
  raw(std::span<double>(&value, 1));
  return value;
}

std::string ArchiveReader::text() {
  const std::vector<char> bytes = list<char>();
  return {bytes.begin(), bytes.end()};
}

std::uint64_t ArchiveReader::count(std::size_t record_bytes) {
  const std::uint64_t count = u64();
  if (count <= (bytes_.size() - at_) / record_bytes) return count;
  fail("it ends too early");
  return 0;
}

void ArchiveReader::fail(std::string_view problem) {
  if (ok()) problem_ = problem;
}

bool ArchiveReader::complete() {
  if (ok() && at_ != bytes_.size()) fail("it is longer than it says");
  return ok();
}

void ArchiveReader::fill(void* out, std::size_t count) {
  if (count > bytes_.size() - at_) fail("it ends too early");
  if (count == 0) return;
  if (!ok()) {
    std::memset(out, 0, count);
    return;
  }
  std::memcpy(out, bytes_.data() + at_, count);
  at_ += count;
}

void ArchiveReader::check_finite(std::span<const float> values) {
  if (!std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); }))
    fail("a value is not finite");
}

void ArchiveReader::check_finite(std::span<const double> values) {
  if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
    fail("a value is not finite");
}

}  // namespace pentimento::checkpoint
