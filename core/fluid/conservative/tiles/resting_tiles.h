#pragma once
// Tiles whose memory goes back to the system: on a large canvas paint moves here and there, and
// most of what was once awake sleeps. Its workspace holds zeros, which need no memory.

#include <cstdint>
#include <vector>

#include "core/canvas/cell_box.h"
#include "core/fluid/conservative/tiles/sleep_tiles.h"

namespace pentimento::conservative {

class RestingTiles {
 public:
  /// Call it once a step, when it is known who is awake. Every kStepsBetweenGivingBack steps: boxes
  /// of tiles that sleep, side by side as many as there are in a row of tiles, if one of them was
  /// awake since it was last in a box. Else none.
  std::vector<CellBox> find(const SleepTiles& tiles);

 private:
  std::vector<std::uint8_t> used_;  // per tile: awake since it was last in a box
  int steps_ = 0;                   // since the last look
};

}  // namespace pentimento::conservative
