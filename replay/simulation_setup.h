#pragma once
// A simulation's setup, as far as the header of a log alone tells it.

#include "core/simulation.h"
#include "formats/log/events.h"

namespace pentimento {

/// The header's canvas and grid, steps and the paper's colour in the optics of `model`, which the
/// simulation runs with. Its basis and its relief are the caller's to add: one follows from the
/// palette, the other may be in a file.
SimulationSetup simulation_setup(const log::Header& header, const Model& model);

}  // namespace pentimento
