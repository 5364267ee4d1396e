#include "replay/batch/matching_files.h"

#include <glob.h>

#include <string_view>

namespace pentimento {

namespace {
/// A path as a pattern that matches it alone.
std::string escaped(const std::string& path) {
  std::string pattern;
  for (const char c : path) {
    if (std::string_view("*?[\\").find(c) != std::string_view::npos) pattern.push_back('\\');
    pattern.push_back(c);
  }
  return pattern;
}

std::string without_ending(std::string name) {
  for (const std::string_view ending : {".gz", ".zst", ".jsonl"}) {
    if (name.ends_with(ending)) name.resize(name.size() - ending.size());
  }
  return name;
}
}  // namespace

std::vector<MatchingFile> matching_files(const std::string& folder, const std::string& pattern) {
  const std::size_t wildcard = pattern.find_first_of("*?[");
  if (wildcard == std::string::npos) return {};
  const bool absolute = pattern.starts_with('/');
  const std::size_t prefix = absolute ? 0 : folder.size() + 1;
  // Where the folders end that have no wildcard.
  const std::size_t slash = pattern.rfind('/', wildcard);
  const std::size_t fixed = slash == std::string::npos ? 0 : slash + 1;
  glob_t found{};
  std::vector<MatchingFile> files;
  const std::string whole = absolute ? pattern : escaped(folder) + "/" + pattern;
  if (glob(whole.c_str(), 0, nullptr, &found) == 0) {
    for (std::size_t i = 0; i < found.gl_pathc; ++i) {
      const std::string path = std::string(found.gl_pathv[i]).substr(prefix);
      files.push_back({path, without_ending(path.substr(fixed))});
    }
  }
  globfree(&found);
  return files;
}

}  // namespace pentimento
