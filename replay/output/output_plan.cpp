#include "replay/output/output_plan.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>
#include <set>

#include "formats/video/video_writer.h"

namespace pentimento {

namespace {
std::optional<OutputKind> kind_of(const std::string& path) {
  if (path == "-") return OutputKind::kPng;
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) {
    return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  });
  if (extension == ".png") return OutputKind::kPng;
  if (extension == ".exr") return OutputKind::kExr;
  if (is_video_name(path)) return OutputKind::kVideo;
  if (extension == ".h5" || extension == ".hdf5") return OutputKind::kState;
  return std::nullopt;
}

std::string with_label(std::string pattern, const std::string& label) {
  for (std::size_t at = pattern.find('%'); at != std::string::npos;
       at = pattern.find('%', at + label.size())) {
    pattern.replace(at, 1, label);
  }
  return pattern;
}

Error usage(std::string message) {
  return {ErrorCode::kUsage, std::move(message)};
}

Result<void> check_patterns(const std::vector<std::string>& patterns, std::size_t stops) {
  for (const std::string& pattern : patterns) {
    if (!kind_of(pattern)) {
      return usage("-o " + pattern +
                   ": the extension must be .png, .exr or .h5 (a film: .avi, .mkv "
                   "or .mp4)");
    }
    if (stops > 1 && pattern.find('%') == std::string::npos) {
      return usage("-o " + pattern + ": several --at need a % in the name");
    }
  }
  return {};
}
}  // namespace

Result<std::vector<std::vector<PlannedOutput>>> plan_outputs(
    const std::vector<std::string>& patterns, const std::vector<StopPoint>& stops) {
  if (Result<void> checked = check_patterns(patterns, stops.size()); !checked) {
    return checked.error();
  }
  std::vector<std::vector<PlannedOutput>> plan(std::max<std::size_t>(1, stops.size()));
  std::set<std::string> names;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    for (const std::string& pattern : patterns) {
      const std::string path = stops.empty() ? pattern : with_label(pattern, stops[i].label);
      const std::string name = std::filesystem::path(path).lexically_normal().string();
      if (!names.insert(name).second) return usage("-o " + path + ": named twice");
      plan[i].push_back({pattern, path, *kind_of(pattern)});
    }
  }
  return plan;
}

}  // namespace pentimento
