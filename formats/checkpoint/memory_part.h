#pragma once
// What the simulation remembers beside its canvas, as a part of a slot.

#include "core/simulation/simulation_memory.h"
#include "formats/checkpoint/archive.h"

namespace pentimento::checkpoint {

void put_memory(const SimulationMemory& memory, ArchiveWriter& to);
SimulationMemory take_memory(ArchiveReader& from);

}  // namespace pentimento::checkpoint
