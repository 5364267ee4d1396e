#include <unistd.h>

#include <cstdlib>
#include <string>

#include "core/shading/gl/context.h"

namespace pentimento {

namespace {
/// The process that Mesa's threads are of; 0 if it has none. They begin with its first context and
/// end with the process, whatever contexts there are.
pid_t process_of_threads(int gl_threads) {
  static const pid_t process = gl_threads > 0 ? getpid() : 0;
  return process;
}
}  // namespace

void keep_compiled_shaders(const std::string& folder) {
  setenv("MESA_SHADER_CACHE_DIR", folder.c_str(), 1);
  setenv("MESA_SHADER_CACHE_MAX_SIZE", "64M", 1);  // ours take 0.1 MB for each kind of processor
  setenv("MESA_SHADER_CACHE_DISABLE", "false", 1);
}

void prepare_mesa(int gl_threads) {
  process_of_threads(gl_threads);
  setenv("LP_NUM_THREADS", std::to_string(gl_threads).c_str(), 1);
  setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
  setenv("EGL_LOG_LEVEL", "fatal", 0);  // it would warn of drivers that it does not find
}

Result<void> check_mesa_threads() {
  const pid_t process = process_of_threads(0);
  if (process == 0 || process == getpid()) return {};
  return Error{
      ErrorCode::kIo,
      "no picture can be made in a process that was forked after one had been made by several "
      "threads: let the canvas have one thread, or start the process anew (spawn)"};
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
