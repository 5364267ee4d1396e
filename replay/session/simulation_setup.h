#pragma once
// The setup of a simulation, as far as it follows from a log's header alone.

#include "core/simulation/simulation.h"
#include "formats/log/tables/events.h"

namespace pentimento {

/// The header's canvas and grid, the duration of a step, and the paper's colour in the optics of
/// `model`, with which the simulation runs. The caller adds the basis, which follows from the
/// palette, and the relief, which may be in a file.
SimulationSetup simulation_setup(const log::Header& header, const Model& model);

}  // namespace pentimento
