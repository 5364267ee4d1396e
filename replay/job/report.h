#pragma once
// The closing report of a job: what was written and what the replay measured (docs/cli.md).

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/canvas/paint_account.h"
#include "core/detail/lock/lock.h"
#include "core/simulation/simulation.h"

namespace pentimento {

/// The meaning of the codes in a picture of numbers: value = offset + per_code * code.
struct WrittenScale {
  double offset = 0, per_code = 0;
  std::string unit;
};

struct WrittenFile {
  std::string file;
  int width = 0;
  int height = 0;
  std::string sha256;
  std::optional<WrittenScale> scale;
};

struct Phase {
  std::string name;
  double wall_s = 0;
};

/// The account of the medium in m^3, or of one channel in amount x m^2.
struct PaintLine {
  std::string name;
  double deposited = 0, picked_up = 0, dried = 0, wet = 0;
  /// (deposited - picked up - dried - wet) / max(deposited, the smallest normal number).
  double relative_difference() const;
};

/// What checkpoints did in a job.
struct CheckpointReport {
  std::string folder;
  std::optional<std::int64_t> resumed_step;  // where the replay went on; none: it began
  bool older_slot = false;                   // the newest slot was damaged
  std::int64_t slots_written = 0;
  std::int64_t bytes_written = 0;
  double wall_s = 0;  // spent on writing
};

struct JobReport {
  std::vector<WrittenFile> outputs;
  std::int64_t steps = 0;
  std::int64_t steps_computed = 0;  // the others were idle and skipped
  double simulated_s = 0;
  double wall_s = 0;
  std::int64_t peak_memory_bytes = 0;
  int threads = 1;
  std::string state_sha256;
  std::string guide_sha256;
  int detail = 1;              // fine cells per cell of the simulation
  std::string other_painting;  // why it is not the painting of the log's grid; empty: it is
  std::string log_sha256;
  std::vector<PaintLine> paint;  // the medium first, then a line per channel
  /// What the lock did (core/detail/lock/lock.h); nullopt at detail 1.
  std::optional<LockStatistics> lock;
  /// What the fluid scheme measured: awake shares, largest speed and depth, and so on.
  std::vector<std::pair<std::string, double>> fluid;
  std::vector<Phase> phases;
  std::vector<std::int64_t> frame_steps;  // steps done at each frame of a film
  std::optional<CheckpointReport> checkpoint;
};

/// The accounts of the medium, then of each channel.
std::vector<PaintLine> paint_lines(const Simulation& simulation);

/// One JSON object, without a newline.
std::string report_json(const JobReport& report);
/// A few lines for people.
std::string report_text(const JobReport& report);

/// The most memory this program has held so far, bytes.
std::int64_t peak_memory_bytes();

}  // namespace pentimento
