#include "replay/batch/job_result.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "formats/io/file_sha256.h"
#include "formats/io/sha256.h"
#include "replay/commands/validate.h"
#include "replay/job/build_info.h"

namespace pentimento {

namespace {
using nlohmann::json;

/// Options that change no byte of a result.
constexpr std::array<std::string_view, 5> kOfTheMachine = {
    "--threads", "--memory-limit", "--scratch", "--checkpoint", "--checkpoint-every"};

/// Empty for a file that cannot be read.
std::string hash_of_file(const std::string& path) {
  const Result<std::string> hash = file_sha256(path);
  return hash ? *hash : std::string();
}

std::vector<std::string> without_the_machines(const std::vector<std::string>& options) {
  std::vector<std::string> kept;
  for (std::size_t i = 0; i < options.size(); ++i) {
    const std::string_view word = options[i];
    const std::string_view name = word.substr(0, word.find('='));
    if (std::find(kOfTheMachine.begin(), kOfTheMachine.end(), name) == kOfTheMachine.end())
      kept.push_back(options[i]);
    else if (name == word)
      ++i;  // its value is the next word
  }
  return kept;
}

/// The values of options that are files' names, with their hashes.
void add_files_of_options(const std::vector<std::string>& options, const std::string& folder,
                          std::map<std::string, std::string>& files) {
  for (const std::string& word : options) {
    const std::string value = word.starts_with("--") && word.find('=') != std::string::npos
                                  ? word.substr(word.find('=') + 1)
                                  : word;
    const std::filesystem::path path = std::filesystem::path(folder) / value;
    std::error_code ignored;
    if (value.empty() || !std::filesystem::is_regular_file(path, ignored)) continue;
    files[value] = hash_of_file(path.string());
  }
}
}  // namespace

std::string JobInputs::key() const {
  const json all = {{"log", log_sha256}, {"files", files}, {"options", options}, {"build", build}};
  return sha256_hex(all.dump(-1, ' ', false, json::error_handler_t::replace));
}

JobInputs inputs_of(const BatchJob& job, const std::string& folder, const std::string& build) {
  JobInputs inputs;
  inputs.build = build;
  inputs.options = without_the_machines(job.options);
  const std::string log = (std::filesystem::path(folder) / job.log).string();
  inputs.log_sha256 = hash_of_file(log);
  log::ReaderOptions reading;
  reading.salvage = true;
  reading.allow_outside =
      std::find(job.options.begin(), job.options.end(), "--allow-outside") != job.options.end();
  if (const Result<LogFacts> facts = validate_log(log, reading)) inputs.files = facts->files;
  add_files_of_options(inputs.options, folder, inputs.files);
  return inputs;
}

std::string build_key(const std::string& program) {
  return software() + " " + hash_of_file(program);
}

bool JobResult::is_final() const {
  constexpr int kIoFailed = 5, kInterruptedCode = 75, kNotStartedCode = 127;
  return done.end == ChildEnd::kExit && done.code != kIoFailed && done.code != kInterruptedCode &&
         done.code != kNotStartedCode;
}

std::string result_json(const JobResult& result) {
  json out = {{"key", result.key},
              {"end", std::string(name_of(result.done.end))},
              {"code", result.done.code},
              {"wall_s", result.done.wall_s},
              {"peak_memory_bytes", result.done.peak_memory_bytes},
              {"message", result.message},
              {"state_sha256", result.state_sha256},
              {"guide_sha256", result.guide_sha256},
              {"finished", result.finished}};
  const json report = json::parse(result.report_json, nullptr, false);
  if (report.is_object()) out["report"] = report;
  return out.dump(-1, ' ', false, json::error_handler_t::replace);
}

Result<JobResult> parse_result(const std::string& text, const std::string& name) {
  const json object = json::parse(text, nullptr, false);
  try {
    JobResult result;
    const std::string end = object.at("end");
    for (const ChildEnd one : {ChildEnd::kExit, ChildEnd::kSignal, ChildEnd::kTimeout,
                               ChildEnd::kMemory, ChildEnd::kStopped})
      if (end == name_of(one)) result.done.end = one;
    result.key = object.at("key");
    result.done.code = object.at("code");
    result.done.wall_s = object.at("wall_s");
    result.done.peak_memory_bytes = object.at("peak_memory_bytes");
    result.message = object.at("message");
    result.state_sha256 = object.at("state_sha256");
    result.guide_sha256 = object.at("guide_sha256");
    result.finished = object.at("finished");
    if (object.contains("report")) result.report_json = object.at("report").dump();
    return result;
  } catch (const json::exception&) {
    return Error{ErrorCode::kBadInput, name + ": not the result of a job"};
  }
}

}  // namespace pentimento
