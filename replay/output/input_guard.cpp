#include "replay/output/input_guard.h"

#include <fmt/format.h>
#include <unistd.h>

#include <map>

#include "formats/io/file_place.h"

namespace pentimento {

Result<void> check_inputs_stay(const std::vector<std::string>& outputs,
                               const std::vector<InputFile>& inputs) {
  std::map<FilePlace, const InputFile*> read;
  for (const InputFile& input : inputs) {
    if (input.path.empty()) continue;
    const auto place = input.path == "-" ? place_of_descriptor(STDIN_FILENO) : place_of(input.path);
    if (place) read.emplace(*place, &input);
  }
  for (const std::string& output : outputs) {
    const auto place = output == "-" ? place_of_descriptor(STDOUT_FILENO) : place_of(output);
    if (!place) continue;
    if (const auto same = read.find(*place); same != read.end())
      return Error{ErrorCode::kUsage,
                   fmt::format("-o {}: would replace {}", output, same->second->what)};
  }
  return {};
}

Result<void> check_outputs_differ(const std::vector<std::string>& outputs) {
  std::map<FilePlace, std::string> written;
  for (const std::string& output : outputs) {
    const auto place = output == "-" ? place_of_descriptor(STDOUT_FILENO) : place_of(output);
    if (!place) continue;
    const auto [same, is_new] = written.emplace(*place, output);
    if (!is_new && same->second != output)
      return Error{ErrorCode::kUsage,
                   fmt::format("-o {}: is the same file as {}", output, same->second)};
  }
  return {};
}

std::vector<std::string> paths_of(const std::vector<std::vector<PlannedOutput>>& outputs) {
  std::vector<std::string> paths;
  for (const std::vector<PlannedOutput>& stop : outputs)
    for (const PlannedOutput& output : stop) paths.push_back(output.path);
  return paths;
}

std::vector<InputFile> files_read_by(const RenderJob& job, const LogFiles& named) {
  std::vector<InputFile> inputs = {{job.log, "the log"},
                                   {job.from, "the state of --from"},
                                   {job.light.environment, "the picture of --environment"}};
  for (const auto& [name, path] : named.paths())
    inputs.push_back({path, fmt::format("\"{}\", which the log names", name)});
  return inputs;
}

}  // namespace pentimento
