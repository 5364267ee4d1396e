#include "core/detail/store/released_blocks.h"

#include <algorithm>
#include <utility>

namespace pentimento {

void ReleasedBlocks::stamped(const CellBox& box, Vec2f way) {
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      if (mark_(x, y) == kNone) cells_.push_back({y, x});
      mark_(x, y) = kNow;
      way_(x, y) = way;
    }
  }
}

std::vector<ReleasedBlock> ReleasedBlocks::step() {
  std::vector<ReleasedBlock> left;
  std::vector<Cell> stay;
  std::sort(cells_.begin(), cells_.end());
  for (const Cell& c : cells_) {
    std::uint8_t& mark = mark_(c.x, c.y);
    if (mark == kNow) {
      mark = kBefore;
      stay.push_back(c);
    } else {
      mark = kNone;
      const int blocks = layout_.blocks();
      left.push_back(
          {{layout_.tile_of(c.x / blocks, c.y / blocks), c.y, c.x, c.x + 1}, way_(c.x, c.y)});
    }
  }
  cells_ = std::move(stay);
  return left;
}

void ReleasedBlocks::clear() {
  for (const Cell& c : cells_) mark_(c.x, c.y) = kNone;
  cells_.clear();
}

std::vector<StampedBlock> ReleasedBlocks::stamped() const {
  std::vector<StampedBlock> stamped;
  for (const Cell& c : cells_)
    stamped.push_back({c.x, c.y, way_(c.x, c.y), mark_(c.x, c.y) == kNow});
  std::sort(stamped.begin(), stamped.end(), [](const StampedBlock& a, const StampedBlock& b) {
    return std::pair(a.y, a.x) < std::pair(b.y, b.x);
  });
  return stamped;
}

void ReleasedBlocks::restore(const std::vector<StampedBlock>& stamped) {
  clear();
  for (const StampedBlock& block : stamped) {
    if (mark_(block.x, block.y) == kNone) cells_.push_back({block.y, block.x});
    mark_(block.x, block.y) = block.now ? kNow : kBefore;
    way_(block.x, block.y) = block.way;
  }
}

}  // namespace pentimento
