#include "core/detail/refinement.h"

#include <algorithm>

#include "core/detail/dry_detail.h"
#include "core/detail/level_detail.h"
#include "core/detail/move_detail.h"
#include "core/detail/moving_tiles.h"
#include "core/detail/restore_detail.h"
#include "core/fluid/scheme.h"

namespace pentimento {

namespace {
std::vector<int> listed(const std::vector<std::uint8_t>& flag) {
  std::vector<int> tiles;
  for (std::size_t t = 0; t < flag.size(); ++t)
    if (flag[t] != 0) tiles.push_back(static_cast<int>(t));
  return tiles;
}

void zero_edges(PaintEdges& edges, const std::vector<conservative::Run>& runs) {
  for (auto* axis : {&edges.x, &edges.y})
    for (Field<float>& plane : *axis)
      for (const conservative::Run& run : runs)
        std::fill_n(plane.row(run.y) + run.x0, run.size(), 0.0f);
}
}  // namespace

Refinement::Refinement(RefinementSetup setup, const DetailGround& ground, TileStore& store,
                       const Threads& threads)
    : setup_(std::move(setup)),
      threads_(threads),
      canvas_(DetailLayout(setup_.guide, setup_.factor), setup_.layers, setup_.channels,
              setup_.bands, ground, store),
      stamp_(canvas_, setup_.amount, threads),
      lock_(canvas_.layout(), setup_.layers),
      edges_(setup_.guide, setup_.layers),
      changed_(static_cast<std::size_t>(canvas_.layout().tiles()), 0) {}

void Refinement::flag(const std::vector<int>& tiles) {
  for (const int t : tiles) changed_[static_cast<std::size_t>(t)] = 1;
}

void Refinement::lay(const StampPlan& plan, const CanvasState& guide) {
  stamp_.lift(plan, guide);
  flag(stamp_.tiles());
}

void Refinement::laid(const StampPlan& plan, const CanvasState& guide) {
  stamp_.lay(plan, guide);
}

void Refinement::moved(const CanvasState& guide, const StepInput& in,
                       const std::vector<conservative::Run>& runs) {
  const std::vector<std::uint8_t> moving = moving_tiles(canvas_.layout(), edges_, runs);
  const std::vector<int> tiles = listed(moving);
  for (const int t : tiles) canvas_.cover(t, guide);
  const MoveDetail move{in.model.pigment_residue, setup_.amount};
  const LineAxis first = edges_.x_first ? LineAxis::kX : LineAxis::kY;
  const LineAxis second = edges_.x_first ? LineAxis::kY : LineAxis::kX;
  for (const LineAxis axis : {first, second})
    move_detail(canvas_, edges_, axis, moving, move, threads_);
  level_detail(canvas_, guide, edges_, in, moving);
  flag(tiles);
  zero_edges(edges_, runs);
}

void Refinement::stepped(const CanvasState& guide, const StepInput&) {
  const std::vector<int> tiles = listed(changed_);
  if (tiles.empty() && recent_.empty()) return;
  for (const int t : tiles) canvas_.cover(t, guide);
  if (setup_.locked) lock_.lock(canvas_, guide, tiles, threads_);
  for (const int t : recent_)
    if (changed_[static_cast<std::size_t>(t)] == 0) canvas_.prune(t, guide);
  recent_ = tiles;
  for (const int t : tiles) canvas_.touch(t);
  canvas_.trim();
  std::fill(changed_.begin(), changed_.end(), std::uint8_t{0});
}

void Refinement::drying(const CanvasState&, const ChannelBasis& basis, const Model& model) {
  dry_detail(canvas_, basis, model, threads_);
}

void Refinement::cleared() {
  canvas_.clear();
  recent_.clear();
  std::fill(changed_.begin(), changed_.end(), std::uint8_t{0});
}

void Refinement::restored(const CanvasState& guide) {
  cleared();
  restore_detail(canvas_, guide, threads_);
  if (!setup_.locked) return;
  std::vector<int> all;
  for (int t = 0; t < canvas_.layout().tiles(); ++t)
    if (canvas_.find(t) != nullptr) all.push_back(t);
  lock_.lock(canvas_, guide, all, threads_);
}

}  // namespace pentimento
