#pragma once
// Whether forces get anywhere in a box of cells: it decides which tiles are solved for, and which
// wake when gravity turns. The faces all around the box count, too.

#include "core/fluid/conservative/solve/workspace.h"

namespace pentimento::conservative {

/// Whether any paint of the box feels gravity: at a face with a mobility.
bool feels_gravity(const Workspace& work, const CellBox& box);

/// Whether a force would move any paint of the box: at such a face that is not held.
bool gives_way(const Workspace& work, const CellBox& box);

}  // namespace pentimento::conservative
