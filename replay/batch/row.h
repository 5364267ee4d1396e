#pragma once
// A row of a batch's report: an id, what became of its job, and the verdict on it.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "replay/batch/job_result.h"

namespace pentimento {

/// Why a row failed, if it did.
enum class RowKind {
  kPassed,
  kExit,              // another exit code than expected
  kCrash,             // a signal ended the program
  kTimeout,           // it took too long
  kMemory,            // it took too much memory
  kState,             // another state than expected or than the golden one
  kPicture,           // another picture than the golden one
  kNoGolden,          // nothing to compare with
  kNotDeterministic,  // two results of one key
  kNotRun
};

/// "passed", "exit", "crash", "timeout", "memory", "state", "picture", "no golden",
/// "not deterministic", "not run".
std::string_view name_of(RowKind kind);

/// A field of the state, or a channel of the picture, that differs from the golden one.
struct GoldenDifference {
  std::string of;      // "state" or "picture"
  std::string name;    // of the plane
  double max = 0;      // largest difference
  double share = 0;    // of the values that differ
  int x = -1, y = -1;  // where the largest is, cell or pixel from the top left; -1: nowhere
};

struct BatchRow {
  std::string id;
  RowKind kind = RowKind::kNotRun;
  std::vector<std::string> reasons;  // a sentence each
  std::string key;
  JobResult result;
  std::vector<GoldenDifference> differences;
  std::string golden_picture_sha256;  // kept in the run's folder; empty if it did not differ
  std::optional<double> flip;         // mean, against the golden picture
  std::optional<double> last_wall_s;  // that the id's job took with another key

  bool passed() const { return kind == RowKind::kPassed; }
};

std::string row_json(const BatchRow& row);
/// `name` for messages. Errors: kBadInput.
Result<BatchRow> parse_row(const std::string& text, const std::string& name);

}  // namespace pentimento
