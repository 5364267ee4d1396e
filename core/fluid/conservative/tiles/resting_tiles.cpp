#include "core/fluid/conservative/tiles/resting_tiles.h"

#include "core/base/give_back.h"

namespace pentimento::conservative {

std::vector<CellBox> RestingTiles::find(const SleepTiles& tiles) {
  used_.resize(static_cast<std::size_t>(tiles.count()), 0);
  for (const int tile : tiles.awake_tiles()) used_[static_cast<std::size_t>(tile)] = 1;
  if (++steps_ < kStepsBetweenGivingBack) return {};
  steps_ = 0;
  std::vector<CellBox> boxes;
  for (int row = 0; row < tiles.rows(); ++row) {
    for (int column = 0; column < tiles.columns(); ++column) {
      if (tiles.awake(column, row)) continue;
      // As far as sleep goes.
      const int first = column;
      bool any_used = false;
      for (; column < tiles.columns() && !tiles.awake(column, row); ++column) {
        std::uint8_t& used = used_[static_cast<std::size_t>(row * tiles.columns() + column)];
        any_used = any_used || used != 0;
        used = 0;
      }
      if (!any_used) continue;
      const int left = row * tiles.columns() + first, right = row * tiles.columns() + column - 1;
      const CellBox box = tiles.box(left);
      boxes.push_back({box.x0, tiles.box(right).x1, box.y0, box.y1});
    }
  }
  return boxes;
}

}  // namespace pentimento::conservative
