#pragma once
// `pentimento verify`: replays a log, and compares the state after each step with what was recorded
// by `render --hashes`.

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "replay/hashes/hash_checker.h"
#include "replay/job/control.h"
#include "replay/job/render_job.h"

namespace pentimento {

struct VerifyRequest {
  /// What to replay, with which changes; its outputs and its size are not used.
  RenderJob job;
  std::string hashes;
  /// Names a dump, with a `%` that becomes `before` (the last state that was as recorded), `after`
  /// (the first that was not) and, with `recorded_by`, `recorded`. Empty: none is written.
  std::string dumps;
  /// The program that recorded the hashes, which replays to the same step; empty: none.
  std::string recorded_by;
};

struct VerifyReport {
  std::int64_t steps = 0;  // that are as recorded
  std::optional<HashDifference> difference;
  double time_s = 0;  // of the difference's step
  std::string event;  // type of the event in the difference's line; empty if there is none
  CanvasGeometry grid;
  std::string recorded_command, recorded_software;
  std::vector<std::string> dumps;  // written
  std::string comparison;          // of `recorded` and `after`, as `compare` tells it
};

/// Errors: those of the log and of the hashes; kBadInput if the hashes are of another log or grid.
Result<VerifyReport> verify(const VerifyRequest& request, const Control& control);

/// For people, lines ending in '\n'; for programs, one JSON object.
std::string verify_text(const VerifyReport& report);
std::string verify_json(const VerifyReport& report);

}  // namespace pentimento
