#include "replay/batch/manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "formats/io/read_file.h"
#include "formats/io/sha256.h"
#include "formats/log/json/nearest_name.h"
#include "replay/batch/matching_files.h"

namespace pentimento {

namespace {
using nlohmann::json;

constexpr std::int64_t kMostManifestBytes = std::int64_t{1} << 28;
constexpr std::size_t kMostIdBytes = 200;
constexpr std::array<std::string_view, 6> kKeys = {"id",     "log",       "options",
                                                   "expect", "timeout_s", "memory_bytes"};
constexpr std::array<std::string_view, 6> kExpectKeys = {"exit", "state_sha256", "state",
                                                         "flip", "psnr",         "max"};
/// What the batch itself says to `render`.
constexpr std::array<std::string_view, 9> kOwnOptions = {"-o",           "--output",   "--json",
                                                         "--quiet",      "--progress", "--dry-run",
                                                         "--no-clobber", "--hashes",   "-h"};

/// Reads the members of one object; the first thing that is wrong stays.
class ManifestLine {
 public:
  explicit ManifestLine(const json& object) : object_(object) {}

  template <std::size_t N>
  void only(const std::array<std::string_view, N>& names) {
    for (const auto& [key, value] : object_.items()) {
      if (std::find(names.begin(), names.end(), key) == names.end())
        wrong("no field is called \"" + key + "\"" + did_you_mean(key, names));
    }
  }
  std::string text(const char* name, bool required = false) {
    if (!object_.contains(name)) {
      if (required) wrong(fmt::format("\"{}\" is missing", name));
      return {};
    }
    if (!object_[name].is_string()) wrong(fmt::format("\"{}\" is not a string", name));
    return problem_.empty() ? object_[name].get<std::string>() : std::string();
  }
  std::optional<double> number(const char* name, double least, double most) {
    if (!object_.contains(name)) return std::nullopt;
    const json& value = object_[name];
    if (!value.is_number() || !(value.get<double>() >= least) || !(value.get<double>() <= most)) {
      wrong(fmt::format("\"{}\" is not a number from {} to {}", name, least, most));
      return std::nullopt;
    }
    return value.get<double>();
  }
  const json* member(const char* name) const {
    return object_.contains(name) ? &object_[name] : nullptr;
  }
  void wrong(const std::string& what) {
    if (problem_.empty()) problem_ = what;
  }
  const std::string& problem() const { return problem_; }

 private:
  const json& object_;
  std::string problem_;
};

Expectation expectation_of(const json& object, ManifestLine& outer) {
  Expectation expect;
  if (!object.is_object()) {
    outer.wrong("\"expect\" is not an object");
    return expect;
  }
  ManifestLine members(object);
  members.only(kExpectKeys);
  expect.exit_code = static_cast<int>(members.number("exit", 0, 255).value_or(0));
  expect.state_sha256 = members.text("state_sha256");
  expect.picture.flip = members.number("flip", 0, 1);
  expect.picture.psnr_db = members.number("psnr", 0, 1000);
  expect.picture.max = members.number("max", 0, 1);
  const std::string state = members.text("state");
  if (!state.empty() && state != "same" && state != "any")
    members.wrong("\"state\" is neither \"same\" nor \"any\"");
  // Who says how far a picture may be off expects that the paint is, too.
  expect.any_state = state.empty() ? expect.picture.any() : state == "any";
  if (!members.problem().empty()) outer.wrong(members.problem());
  return expect;
}

std::vector<std::string> options_of(const json& list, ManifestLine& outer) {
  std::vector<std::string> options;
  if (!list.is_array()) outer.wrong("\"options\" is not a list of words");
  if (!list.is_array()) return options;
  for (const json& word : list) {
    if (!word.is_string()) {
      outer.wrong("\"options\" holds something that is not a string");
      return options;
    }
    options.push_back(word.get<std::string>());
    const std::string name = options.back().substr(0, options.back().find('='));
    if (std::find(kOwnOptions.begin(), kOwnOptions.end(), name) != kOwnOptions.end() ||
        (name.starts_with("-o") && !name.starts_with("--")))
      outer.wrong("\"options\": " + name + " is the batch's own");
  }
  return options;
}

void check_id(const std::string& id, ManifestLine& members) {
  if (id.empty()) members.wrong("\"id\" is empty");
  if (id.size() > kMostIdBytes)
    members.wrong(fmt::format("\"id\" has more than {} bytes", kMostIdBytes));
  if (std::any_of(id.begin(), id.end(),
                  [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }))
    members.wrong("\"id\" holds a control character");
}

/// The job of one line; what is wrong with it goes into `problem`.
BatchJob job_of(const std::string& line, std::string& problem) {
  BatchJob job;
  const json object = json::parse(line, nullptr, false);
  if (!object.is_object()) {
    problem = "not a JSON object";
    return job;
  }
  ManifestLine members(object);
  members.only(kKeys);
  job.id = members.text("id", true);
  job.log = members.text("log", true);
  check_id(job.id, members);
  if (job.log.empty() || job.log == "-") members.wrong("\"log\" is not the name of a file");
  if (const json* options = members.member("options")) job.options = options_of(*options, members);
  if (const json* expect = members.member("expect")) job.expect = expectation_of(*expect, members);
  job.timeout_s = members.number("timeout_s", 0.01, 1e7);
  if (const auto bytes = members.number("memory_bytes", 1 << 20, 1e15))
    job.memory_bytes = static_cast<std::int64_t>(*bytes);
  problem = members.problem();
  return job;
}

json job_json(const BatchJob& job) {
  json expect = {{"exit", job.expect.exit_code}, {"state", job.expect.any_state ? "any" : "same"}};
  if (!job.expect.state_sha256.empty()) expect["state_sha256"] = job.expect.state_sha256;
  if (job.expect.picture.flip) expect["flip"] = *job.expect.picture.flip;
  if (job.expect.picture.psnr_db) expect["psnr"] = *job.expect.picture.psnr_db;
  if (job.expect.picture.max) expect["max"] = *job.expect.picture.max;
  json out = {{"id", job.id}, {"log", job.log}, {"options", job.options}, {"expect", expect}};
  if (job.timeout_s) out["timeout_s"] = *job.timeout_s;
  if (job.memory_bytes) out["memory_bytes"] = *job.memory_bytes;
  return out;
}

/// The job, or one for each file that its pattern matches. A pattern that matches nothing stays:
/// the job fails then, as one whose log is missing.
std::vector<BatchJob> expanded(const BatchJob& job, const std::string& folder) {
  std::vector<BatchJob> jobs;
  for (const MatchingFile& file : matching_files(folder, job.log)) {
    jobs.push_back(job);
    jobs.back().id = job.id + "/" + file.name;
    jobs.back().log = file.path;
  }
  return jobs.empty() ? std::vector<BatchJob>{job} : jobs;
}

Result<std::vector<BatchJob>> parse_lines(const std::string& text, const std::string& name,
                                          const std::string* folder) {
  std::vector<BatchJob> jobs;
  std::set<std::string> ids;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    std::string problem;
    const BatchJob job = job_of(line, problem);
    const auto here = [&](const std::string& what) {
      return Error{ErrorCode::kBadInput, fmt::format("{}:{}: {}", name, number, what)};
    };
    if (!problem.empty()) return here(problem);
    for (BatchJob& one : folder ? expanded(job, *folder) : std::vector<BatchJob>{job}) {
      if (!ids.insert(one.id).second) return here("a second job has the id \"" + one.id + "\"");
      jobs.push_back(std::move(one));
    }
  }
  return jobs;
}
}  // namespace

Result<Manifest> read_manifest(const std::string& path) {
  Result<std::string> text = read_file(path, kMostManifestBytes);
  if (!text) return text.error();
  Manifest manifest;
  std::error_code ignored;
  manifest.folder = path == "-" ? std::filesystem::current_path(ignored).string()
                                : std::filesystem::absolute(path, ignored).parent_path().string();
  Result<std::vector<BatchJob>> jobs = parse_lines(*text, path, &manifest.folder);
  if (!jobs) return jobs.error();
  if (jobs->empty()) return Error{ErrorCode::kBadInput, path + ": the manifest has no job"};
  manifest.jobs = std::move(*jobs);
  return manifest;
}

Result<std::vector<BatchJob>> parse_manifest(const std::string& text, const std::string& name) {
  return parse_lines(text, name, nullptr);
}

std::string manifest_text(const std::vector<BatchJob>& jobs) {
  std::string text;
  for (const BatchJob& job : jobs)
    text += job_json(job).dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
  return text;
}

int shard_of(const std::string& id, int count) {
  // The first 15 digits of the hash, which a 64-bit number holds.
  const unsigned long long head = std::stoull(sha256_hex(id).substr(0, 15), nullptr, 16);
  return static_cast<int>(head % static_cast<unsigned long long>(count)) + 1;
}

}  // namespace pentimento
