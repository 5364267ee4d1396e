#pragma once
// A slot: a moment of a replay between two steps, with all that it takes to go on from there. The
// planes of the detail canvas lie in files of their own.

#include <optional>
#include <string>

#include "core/canvas/canvas_state.h"
#include "core/simulation/simulation_memory.h"
#include "formats/checkpoint/canvas_part.h"
#include "formats/checkpoint/detail_part.h"
#include "formats/checkpoint/plane_index.h"
#include "formats/checkpoint/slot_file.h"
#include "replay/checkpoint/binding.h"
#include "replay/output/kept_outputs.h"
#include "replay/play/player.h"

namespace pentimento {

struct Slot {
  Binding binding;
  PlayPosition position;
  std::int64_t step = 0;  // of the state
  std::size_t stops_done = 0;
  std::vector<KeptOutput> outputs;
  CanvasState guide;
  SimulationMemory memory;
  std::optional<checkpoint::DetailNotes> detail;
  checkpoint::PlaneIndex planes;
};

/// What a slot must fit.
struct SlotShape {
  checkpoint::GuideShape guide;
  int detail = 1;
};

/// The binding alone. Errors: kBadInput, with `name`.
Result<Binding> binding_in(const checkpoint::SlotParts& parts, const std::string& name);
/// Everything but the binding. Errors: kBadInput, with `name` and the part.
Result<Slot> decode_slot(const checkpoint::SlotParts& parts, const SlotShape& shape,
                         const std::string& name);

/// Writes `slot` but for its guide, which is `guide` and need not be copied. Returns the file's
/// size in bytes. Errors: kIo.
Result<std::uint64_t> write_slot(const std::string& path, const Slot& slot,
                                 const CanvasState& guide);

}  // namespace pentimento
