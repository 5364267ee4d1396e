#pragma once
// Finds out whether a row holds finite numbers only. It looks at bits, without a branch per value,
// so a check of a whole state costs no more than reading the state.

#include <bit>
#include <cstdint>
#include <span>

namespace pentimento {

inline bool all_finite(std::span<const float> row) {
  constexpr std::uint32_t kExponent = 0x7f800000;  // all ones: infinite or not a number
  std::uint32_t found = 0;
  for (const float value : row)
    found |= (std::bit_cast<std::uint32_t>(value) & kExponent) == kExponent ? 1u : 0u;
  return found == 0;
}

}  // namespace pentimento
