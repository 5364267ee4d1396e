#pragma once
// Modules: libraries beside the program that take long to load and that few jobs need. A module is
// loaded when its first function is asked for, and stays loaded.

#include <string>

#include "core/base/result.h"

namespace pentimento::image {

inline constexpr const char* kTextModule = "pentimento_text.so";
inline constexpr const char* kVideoModule = "pentimento_videos.so";

/// The address of `function` in `module`. Errors: kIo, with the reason.
Result<void*> find_in_module(const char* module, const char* function);

template <typename Signature>
struct ModuleFunction {
  Signature* call = nullptr;
};

/// The same with a type: `Signature` is the signature of the function.
template <typename Signature>
Result<ModuleFunction<Signature>> module_function(const char* module, const char* function) {
  Result<void*> found = find_in_module(module, function);
  if (!found) return found.error();
  return ModuleFunction<Signature>{reinterpret_cast<Signature*>(*found)};
}

}  // namespace pentimento::image
