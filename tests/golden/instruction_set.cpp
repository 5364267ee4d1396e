#include "tests/golden/instruction_set.h"

namespace pentimento {
namespace {

// Three versions, chosen as those of a kernel are: each tells its own name.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
__attribute__((target("default"))) const char* chosen() {
  return "sse2";
}
__attribute__((target("arch=x86-64-v3"))) const char* chosen() {
  return "avx2";
}
__attribute__((target("arch=x86-64-v4"))) const char* chosen() {
  return "avx512";
}
#else
const char* chosen() {
  return "default";
}
#endif

}  // namespace

const char* instruction_set() {
  return chosen();
}

}  // namespace pentimento
