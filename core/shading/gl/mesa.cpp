#include <cstdlib>
#include <string>

#include "core/shading/gl/context.h"

namespace pentimento {

void prepare_mesa(int gl_threads) {
  setenv("LP_NUM_THREADS", std::to_string(gl_threads).c_str(), 1);
  setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
}

}  // namespace pentimento

#if defined(__SANITIZE_ADDRESS__)
#define PENTIMENTO_LEAK_CHECK 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define PENTIMENTO_LEAK_CHECK 1
#endif
#endif
#ifdef PENTIMENTO_LEAK_CHECK
// Mesa keeps the window of each context it ever made current. The checker looks for this name.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libOSMesa\nleak:libEGL\nleak:libgallium\nleak:swrast_dri\n";
}
// It also looks for this name. It would list the leaks that it ignores on standard error, where the
// program's own messages go.
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_options() {
  return "print_suppressions=0";
}
#endif
