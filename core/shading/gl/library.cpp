#include "core/shading/gl/library.h"

#include <dlfcn.h>

namespace pentimento {

Result<SharedLibrary> SharedLibrary::open(std::initializer_list<const char*> names) {
  std::string reason;
  for (const char* name : names) {
    // Symbols stay local, so that two OpenGL libraries in one process do not mix.
    if (void* handle = dlopen(name, RTLD_NOW | RTLD_LOCAL)) return SharedLibrary(handle);
    if (reason.empty()) reason = dlerror();
  }
  return Error{ErrorCode::kIo, reason};
}

void* SharedLibrary::symbol(const char* name) const {
  return dlsym(handle_, name);
}

}  // namespace pentimento
