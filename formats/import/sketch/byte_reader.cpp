#include "formats/import/sketch/byte_reader.h"

#include <fmt/format.h>

#include <cmath>

namespace pentimento::sketch {

float ByteReader::f32(std::string_view field) {
  const float value = take<float>(field);
  if (std::isfinite(value)) return value;
  fail(fmt::format("{} is not finite", field));
  return 0;
}

double ByteReader::f64(std::string_view field) {
  const double value = take<double>(field);
  if (std::isfinite(value)) return value;
  fail(fmt::format("{} is not finite", field));
  return 0;
}

std::string_view ByteReader::bytes(std::size_t count, std::string_view field) {
  if (ok() && count > left())
    fail(fmt::format("{} is cut short: {} bytes are needed, {} are left", field, count, left()));
  if (!ok()) return {};
  at_ += count;
  return bytes_.substr(at_ - count, count);
}

std::uint32_t ByteReader::count(std::string_view field, std::size_t record_bytes) {
  const std::uint32_t declared = u32(field);
  if (!ok()) return 0;
  if (declared > left() / record_bytes)
    fail(fmt::format("{} {} cannot be: {} bytes are left, each needs at least {}", declared, field,
                     left(), record_bytes));
  return ok() ? declared : 0;
}

void ByteReader::fail(std::string problem) {
  if (ok()) problem_ = fmt::format("{}: offset {}: {}", name_, offset(), problem);
}

}  // namespace pentimento::sketch
