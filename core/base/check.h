#pragma once
// Checks of core's invariants. Input is validated before it reaches core, so a failed check is a
// bug of ours: the check says where it stands and aborts. PENTIMENTO_CHECK stays in release builds
// and belongs outside loops; PENTIMENTO_DCHECK is for the inside of loops.

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
