#pragma once
// Compares a replay with a file of hashes, step by step, and finds where they part.

#include <optional>
#include <string>
#include <vector>

#include "replay/hashes/field_hashes.h"
#include "replay/hashes/hash_file.h"
#include "replay/play/step_observer.h"

namespace pentimento {

/// The first step after which a replay is not what was recorded.
struct HashDifference {
  std::int64_t step = 0;
  std::int64_t last_equal_step = 0;  // 0: none was
  std::int64_t line = 0;             // of the log, of the last event before the step
  std::vector<std::string> fields;   // those that differ, by their names in a dump
  std::vector<CellBox> tiles;        // those that differ, in order
  std::string note;                  // if it is not about hashes: a step that only one of them has
};

class HashChecker final : public StepObserver {
 public:
  HashChecker(const CanvasGeometry& geometry, float sleep_tile_m, const Threads& threads,
              HashReader& recorded)
      : hashes_(geometry, sleep_tile_m), threads_(threads), recorded_(recorded) {}

  /// Errors: those of the file; after a difference kBadInput, to end the replay.
  Result<void> stepped(const CanvasState& state, std::int64_t line, bool whole_canvas) override;
  /// Call it after the last step: nothing may be left in the file.
  Result<void> finish();

  const std::optional<HashDifference>& difference() const { return difference_; }
  std::int64_t steps() const { return steps_; }

 private:
  Error differ(HashDifference difference);
  HashDifference compare(const StepHashes& recorded, std::int64_t step, std::int64_t line) const;

  FieldHashes hashes_;
  const Threads& threads_;
  HashReader& recorded_;
  std::optional<HashDifference> difference_;
  std::int64_t steps_ = 0, last_equal_step_ = 0;
};

}  // namespace pentimento
