#include "cli/shader_folder.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>

#include "core/shading/gl/context.h"

namespace pentimento::cli {

namespace {

constexpr mode_t kForOthersToWrite = S_IWGRP | S_IWOTH;

/// Whether `folder` is there or could be made, and nobody else can put anything into it.
bool is_ours(const std::string& folder) {
  ::mkdir(folder.c_str(), S_IRWXU);  // it may be there
  struct stat found {};
  return ::lstat(folder.c_str(), &found) == 0 && S_ISDIR(found.st_mode) &&
         found.st_uid == ::geteuid() && (found.st_mode & kForOthersToWrite) == 0 &&
         ::access(folder.c_str(), R_OK | W_OK | X_OK) == 0;
}

/// The user's folder for what can be made again. Empty if the user has none.
std::string cache_home() {
  // A relative path is to be ignored, says the specification.
  if (const char* named = std::getenv("XDG_CACHE_HOME"); named != nullptr && *named == '/')
    return named;
  const char* home = std::getenv("HOME");
  return home != nullptr && *home == '/' ? std::string(home) + "/.cache" : std::string();
}

}  // namespace

std::optional<std::string> shader_folder() {
  std::string folder;
  if (const char* named = std::getenv("PENTIMENTO_CACHE"); named != nullptr) {
    folder = named;
  } else if (const std::string home = cache_home(); !home.empty()) {
    ::mkdir(home.c_str(), S_IRWXU);  // it may be there
    folder = home + "/pentimento";
  }
  if (folder.empty() || !is_ours(folder)) return std::nullopt;
  return folder;
}

void use_shader_folder() {
  if (const std::optional<std::string> folder = shader_folder()) keep_compiled_shaders(*folder);
}

}  // namespace pentimento::cli
