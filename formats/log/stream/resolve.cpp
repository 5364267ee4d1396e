#include "formats/log/stream/resolve.h"

#include <fmt/format.h>

#include <algorithm>

namespace pentimento::log {

namespace fs = std::filesystem;

namespace {

Error bad(std::string_view name, std::string_view what) {
  return {ErrorCode::kBadInput, fmt::format("file \"{}\" {}", name, what)};
}

bool is_inside(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
         folder.end();
}

}  // namespace

std::string file_name_problem(std::string_view name, bool allow_outside) {
  if (name.empty()) return "file \"\" is empty";
  if (allow_outside) return {};
  const fs::path path(name);
  if (path.is_absolute()) return fmt::format("file \"{}\" is an absolute path", name);
  if (std::find(path.begin(), path.end(), "..") != path.end()) {
    return fmt::format("file \"{}\" leaves the log's folder", name);
  }
  return {};
}

Result<fs::path> resolve_file(const std::string& log_path, std::string_view name,
                              bool allow_outside) {
  std::string problem = file_name_problem(name, allow_outside);
  if (!problem.empty()) return Error{ErrorCode::kBadInput, std::move(problem)};
  std::error_code error;
  const fs::path parent = log_path == "-" ? fs::path() : fs::path(log_path).parent_path();
  const fs::path folder = fs::canonical(parent.empty() ? fs::path(".") : parent, error);
  if (error) return bad(name, "cannot be found: " + error.message());
  fs::path path = fs::canonical(folder / fs::path(name), error);
  if (error) return bad(name, "cannot be found: " + error.message());
  if (!allow_outside && !is_inside(path, folder)) {
    return bad(name, "leaves the log's folder by a link");
  }
  if (!fs::is_regular_file(path, error)) return bad(name, "is not a regular file");
  return path;
}

}  // namespace pentimento::log
