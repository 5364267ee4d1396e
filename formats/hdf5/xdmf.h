#pragma once
// The XDMF sidecar that lets ParaView open a state dump.

#include <string>

#include "formats/hdf5/state_dump.h"

namespace pentimento {

/// XDMF 3 text that refers to the dump at `path` by its file name. The canvas lies in the x-y
/// plane in metres, y down as in the dump.
std::string xdmf_text(const std::string& path, const StateDump& dump);

}  // namespace pentimento
