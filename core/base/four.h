#pragma once
// Four floats side by side, which every processor adds and multiplies at once.

#include <cstring>

namespace pentimento {

using Four = float __attribute__((vector_size(16)));

/// The four floats from `at` on.
inline Four four_at(const float* at) {
  Four values;
  std::memcpy(&values, at, sizeof(values));
  return values;
}
inline void put_four(const Four& values, float* at) {
  std::memcpy(at, &values, sizeof(values));
}

}  // namespace pentimento
