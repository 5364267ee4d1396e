#include "core/detail/stamp/steepen_edges.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/brush/noise.h"
#include "core/detail/store/block_rows.h"

namespace pentimento {

namespace {
constexpr int kReach = 2;  // guide cells: the edge and the fringe it spreads to
constexpr float kBare = 0.02f;
constexpr float kFringe = 0.06f, kBody = 0.22f;
constexpr float kLeast = 0.2f;  // of a fringe that has a block for itself
// Slope as a share of the largest depth per cell of the guide. The side of a stroke is this steep;
// a stroke that fades out is not.
constexpr float kFading = 0.12f, kSteep = 0.25f;
constexpr float kEnd = 0.4f, kSide = 0.8f;  // squared sine of the slope to the brush's way
constexpr int kBlocksPerTask = 64;

struct Around {
  float least, most;
};

Around around(const Field<float>& depth, int x, int y, int reach) {
  Around found{depth(x, y), depth(x, y)};
  for (int j = std::max(0, y - reach); j <= std::min(depth.height() - 1, y + reach); ++j) {
    const float* row = depth.row(j);
    for (int i = std::max(0, x - reach); i <= std::min(depth.width() - 1, x + reach); ++i) {
      found.least = std::min(found.least, row[i]);
      found.most = std::max(found.most, row[i]);
    }
  }
  return found;
}

/// How strongly a cell is steepened: fully where paint falls steeply across the brush's way.
float strength_at(const Field<float>& depth, int x, int y, float most, Vec2f way) {
  const auto at = [&](int i, int j) {
    return depth(std::clamp(i, 0, depth.width() - 1), std::clamp(j, 0, depth.height() - 1));
  };
  const float along_x = 0.5f * (at(x + 1, y) - at(x - 1, y));
  const float along_y = 0.5f * (at(x, y + 1) - at(x, y - 1));
  const float square = along_x * along_x + along_y * along_y;
  if (!(square > 0)) return 0;
  const float along = way.x * along_x + way.y * along_y;
  return smooth_step(kFading, kSteep, std::sqrt(square) / most) *
         smooth_step(kEnd, kSide, 1 - along * along / square);
}

/// Weights of a block's cells, row by row.
using Weights = std::array<float, static_cast<std::size_t>(kMostDetail) * kMostDetail>;

/// How a block is to be steepened.
struct Gathering {
  float most = 0;      // depth of the body
  float beyond = 0;    // depth that the thinnest block beside it has: no cell becomes thinner
  float strength = 0;  // 0..1, how much of it is done
};

/// False if all are 1.
bool find_weights(const BlockRow& depth, const Gathering& how, Weights& weight) {
  bool any = false;
  std::size_t i = 0;
  for (int y = 0; y < depth.factor; ++y) {
    const float* row = depth.first + y * depth.stride;
    for (int x = 0; x < depth.factor; ++x, ++i) {
      const float body = std::max(kLeast, smooth_step(kFringe, kBody, row[x] / how.most));
      weight[i] = 1 + how.strength * (std::max(body, std::min(1.0f, how.beyond / row[x])) - 1);
      any |= weight[i] != 1 && row[x] > 0;
    }
  }
  return any;
}

void gather(const Weights& weight, const BlockRow& block) {
  float before = 0, after = 0;
  block_means(block, {&before, 1});
  if (!(before > 0)) return;
  std::size_t i = 0;
  for (int y = 0; y < block.factor; ++y) {
    float* row = block.first + y * block.stride;
    for (int x = 0; x < block.factor; ++x) row[x] *= weight[i++];
  }
  block_means(block, {&after, 1});
  const float scale = before / after;
  scale_blocks({&scale, 1}, block);
}

void gather_block(DetailTile& tile, const DetailLayout& layout, const BlockStrip& block,
                  const Gathering& how) {
  Weights weight;
  if (!find_weights(block_row(tile.depth_m.data(), layout, block), how, weight)) return;
  for (int p = -1; p < static_cast<int>(tile.pigment.size()); ++p)
    if (TilePlane& plane = WetPlane{p}.of(tile))
      gather(weight, block_row(plane.data(), layout, block));
}
}  // namespace

void steepen_edges(DetailCanvas& canvas, const CanvasState& guide,
                   const std::vector<ReleasedBlock>& blocks, const Threads& threads) {
  const Field<float>& depth = guide.depth_m;
  const auto gather_one = [&](const ReleasedBlock& block) {
    const int x = block.at.x0, y = block.at.y;
    DetailTile* tile = canvas.find(block.at.tile);
    if (tile == nullptr || !tile->depth_m || !(depth(x, y) > 0)) return;
    const Around near = around(depth, x, y, kReach);
    if (near.least >= kBare * near.most) return;
    const float strength = strength_at(depth, x, y, near.most, block.way);
    if (strength > 0)
      gather_block(*tile, canvas.layout(), block.at,
                   {near.most, around(depth, x, y, 1).least, strength});
  };
  threads.for_ranges(0, static_cast<int>(blocks.size()), kBlocksPerTask, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) gather_one(blocks[static_cast<std::size_t>(i)]);
  });
}

}  // namespace pentimento
