#pragma once

#include <cstddef>
#include <vector>

namespace pentimento {

/// Makes room for `size` values. Scratch grows to the largest use and stays, so that one use after
/// another needs no new memory.
template <typename T>
void grow(std::vector<T>& scratch, std::size_t size) {
  if (scratch.size() < size) scratch.resize(size);
}

}  // namespace pentimento
