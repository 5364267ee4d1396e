#include "formats/image/module_function.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

namespace pentimento::image {

namespace {
/// Beside the command (a build tree), or in the folder of libraries it was installed with.
std::vector<std::filesystem::path> module_places(const char* module) {
  std::error_code error;
  const std::filesystem::path command = std::filesystem::read_symlink("/proc/self/exe", error);
  std::vector<std::filesystem::path> places;
  if (!error) {
    places.push_back(command.parent_path() / module);
    places.push_back(command.parent_path() / ".." / PENTIMENTO_RELATIVE_LIBDIR / module);
  }
  places.push_back(std::filesystem::path(PENTIMENTO_LIBDIR) / module);
  return places;
}
}  // namespace

Result<void*> find_in_module(const char* module, const char* function) {
  // OpenCV takes from the environment how much it talks, when it is loaded.
  ::setenv("OPENCV_LOG_LEVEL", "SILENT", 0);
  std::string why = "it is not installed";
  for (const std::filesystem::path& place : module_places(module)) {
    std::error_code error;
    if (!std::filesystem::exists(place, error)) continue;
    void* loaded = ::dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* found = loaded == nullptr ? nullptr : ::dlsym(loaded, function);
    if (found != nullptr) return found;
    why = ::dlerror();
  }
  return Error{ErrorCode::kIo, fmt::format("cannot load {}: {}", module, why)};
}

}  // namespace pentimento::image
