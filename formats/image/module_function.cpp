#include "formats/image/module_function.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "formats/image/read_image.h"

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
  // OpenCV takes its limits and how much it talks from the environment, when it is loaded.
  const std::string pixels = std::to_string(ImageLimits{}.max_pixels);
  ::setenv("OPENCV_IO_MAX_IMAGE_PIXELS", pixels.c_str(), 0);
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
