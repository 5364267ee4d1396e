#pragma once
// Invariants of core. Input is validated before it reaches core, so a failed check is a bug of
// ours: it says where and aborts. CHECK stays in release builds and belongs outside loops; DCHECK
// is for inside them.

#include <cstdio>
#include <cstdlib>

namespace pentimento {
[[noreturn]] inline void check_failed(const char* what, const char* file, int line) {
  std::fprintf(stderr, "pentimento: internal error: %s does not hold (%s:%d)\n", what, file, line);
  std::abort();
}
}  // namespace pentimento

#define PENTIMENTO_CHECK(x) \
  ((x) ? static_cast<void>(0) : ::pentimento::check_failed(#x, __FILE__, __LINE__))
#ifdef NDEBUG
#define PENTIMENTO_DCHECK(x) static_cast<void>(0)
#else
#define PENTIMENTO_DCHECK(x) PENTIMENTO_CHECK(x)
#endif
