#pragma once
// The manifest of a batch: which logs are rendered with which options, and what is expected of each
// (docs/batch.md). JSON Lines, an object for each job.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "replay/compare/comparison.h"

namespace pentimento {

struct Expectation {
  int exit_code = 0;
  std::string state_sha256;  // empty: not asked
  /// Of the picture, against the golden one: `max`, `psnr_db`, `flip`.
  CompareThresholds picture;
  /// The golden state may be another: only the picture is compared.
  bool any_state = false;
};

struct BatchJob {
  std::string id;
  std::string log;                   // as the manifest's folder sees it
  std::vector<std::string> options;  // of `render`
  Expectation expect;
  std::optional<double> timeout_s;  // in place of the batch's
  std::optional<std::int64_t> memory_bytes;
};

struct Manifest {
  std::string folder;  // of the manifest; logs and options name files from there
  std::vector<BatchJob> jobs;
};

/// Pictures may differ by a code of 8 bits in any place where nothing else is asked for: so much
/// the rounding of two OpenGL drivers differs.
inline constexpr double kMostPictureDifference = 1.001 / 255;

/// Reads a manifest. A `log` with `*`, `?` or `[` stands for every file that it matches, each with
/// an id of its own: ID/ and the part of the path that was matched, without its ending. Errors:
/// kIo; kBadInput with file and line.
Result<Manifest> read_manifest(const std::string& path);

/// The jobs as lines of a manifest, without patterns.
std::string manifest_text(const std::vector<BatchJob>& jobs);
/// What manifest_text() wrote. `name` for messages.
Result<std::vector<BatchJob>> parse_manifest(const std::string& text, const std::string& name);

/// Which of `count` shards a job belongs to, from 1. It depends on the id alone, so a new job moves
/// no other.
int shard_of(const std::string& id, int count);

}  // namespace pentimento
