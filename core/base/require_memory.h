#pragma once

#include <new>

namespace pentimento {

/// For calls of a library that, asked as we ask, fail only where no memory is given: such a failure
/// is one of the machine, and no bug of ours. Throws std::bad_alloc.
inline void require_memory(bool given) {
  if (!given) throw std::bad_alloc();
}

}  // namespace pentimento
