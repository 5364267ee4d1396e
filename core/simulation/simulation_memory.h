#pragma once
// What a simulation remembers from step to step beside its canvas and what its hand set: the paint
// in the brushes, the books, and what the fluid scheme keeps.

#include <cstdint>
#include <vector>

#include "core/brush/reservoir.h"
#include "core/canvas/paint_account.h"

namespace pentimento {

/// A touch that is or was down, and the paint of its brush.
struct TouchMemory {
  int id = 0;
  std::uint32_t stroke_id = 0;
  bool down = false;
  Reservoir::Content reservoir;
};

struct SimulationMemory {
  std::vector<TouchMemory> touches;  // by ascending id
  PaintAccount account;
  std::int64_t stamps = 0;
  bool fresh = false;          // StepInput::fresh, of the next step
  std::vector<double> scheme;  // FluidScheme::memory()
};

}  // namespace pentimento
