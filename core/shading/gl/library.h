#pragma once
// A shared library opened at run time. It stays loaded until the process ends: drivers leave
// threads and exit handlers behind.

#include <initializer_list>
#include <string>

#include "core/base/result.h"

namespace pentimento {

class SharedLibrary {
 public:
  /// The first of `names` that loads.
  static Result<SharedLibrary> open(std::initializer_list<const char*> names);
  /// The symbol as a function pointer, nullptr if missing.
  template <typename F>
  F function(const char* name) const {
    return reinterpret_cast<F>(symbol(name));
  }

 private:
  explicit SharedLibrary(void* handle) : handle_(handle) {}
  void* symbol(const char* name) const;
  void* handle_;
};

}  // namespace pentimento
