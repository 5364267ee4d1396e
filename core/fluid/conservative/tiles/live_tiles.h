#pragma once
// Live tiles: the awake tiles that forces may move. An awake tile is live if paint moves in it, if
// any of its paint gives way to forces, or if it lies beside a live tile. All velocities of the
// others are 0 and stay so, for the faces between tiles that sleep and tiles that do not are walls:
// a step leaves out the solves there, and its result is the same. Fresh stiff paint is so: a tile
// is awake while it is painted, and nothing in it moves but by the brush.

#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/runs.h"
#include "core/base/threads.h"
#include "core/fluid/conservative/tiles/sleep_tiles.h"

namespace pentimento::conservative {

class LiveTiles {
 public:
  /// `stirs(tile)`: whether paint moves or gives way in this tile. It is asked on several threads.
  void find(const SleepTiles& tiles, const Threads& threads,
            const std::function<bool(int tile)>& stirs);
  /// Those of `runs` that lie in live tiles. Awake tiles side by side are all live, or none is: so
  /// are the cells of a run.
  std::vector<Run> live_of(const std::vector<Run>& runs, const SleepTiles& tiles) const;

 private:
  bool live(int tile) const { return live_[static_cast<std::size_t>(tile)] != 0; }
  void spread(const SleepTiles& tiles);

  std::vector<std::uint8_t> live_;
  std::vector<int> edge_;  // live tiles whose neighbours have not been looked at
};

}  // namespace pentimento::conservative
