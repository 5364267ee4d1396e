#pragma once
// Writes a replay's file of hashes while it plays.

#include "replay/hashes/field_hashes.h"
#include "replay/hashes/hash_file.h"
#include "replay/play/step_observer.h"

namespace pentimento {

class HashRecorder final : public StepObserver {
 public:
  /// `threads` and `writer` outlive the recorder.
  HashRecorder(const CanvasGeometry& geometry, float sleep_tile_m, const Threads& threads,
               HashWriter& writer)
      : hashes_(geometry, sleep_tile_m), threads_(threads), writer_(writer) {}
  Result<void> stepped(const CanvasState& state, std::int64_t line, bool whole_canvas) override;

 private:
  FieldHashes hashes_;
  const Threads& threads_;
  HashWriter& writer_;
};

}  // namespace pentimento
