#pragma once
// What a job of a batch gave, as it is kept, and the key under which it is kept.

#include <cstdint>
#include <map>
#include <string>

#include "core/base/result.h"
#include "replay/batch/manifest.h"
#include "replay/process/child.h"

namespace pentimento {

/// Everything that a job's result depends on.
struct JobInputs {
  std::string log_sha256;                    // empty: the log cannot be read
  std::map<std::string, std::string> files;  // that the log or the options name: SHA-256
  std::vector<std::string> options;          // those that can change the result
  std::string build;                         // of the program

  /// SHA-256 of all of them.
  std::string key() const;
};

/// Reads the job's log and the files that it names, as far as they can be read. `build`: see
/// build_key().
JobInputs inputs_of(const BatchJob& job, const std::string& folder, const std::string& build);

/// Names the program that renders, by this program's version and by the bytes of its file.
std::string build_key(const std::string& program);

struct JobResult {
  std::string key;
  ChildDone done;
  std::string message;  // the last line that it said, empty if it ended well
  std::string state_sha256, guide_sha256;
  std::string report_json;  // the closing report, empty without one
  std::string finished;     // UTC, as 2026-11-23T19:00:00Z

  /// Whether it would end so again: not what a crowded machine or a full disk did.
  bool is_final() const;
};

std::string result_json(const JobResult& result);
/// `name` for messages. Errors: kBadInput.
Result<JobResult> parse_result(const std::string& text, const std::string& name);

}  // namespace pentimento
