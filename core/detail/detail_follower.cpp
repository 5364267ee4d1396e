#include "core/detail/detail_follower.h"

#include <algorithm>

#include "core/detail/dry_detail.h"
#include "core/detail/flow/advect_detail.h"
#include "core/detail/flow/level_detail.h"
#include "core/detail/flow/level_relief.h"
#include "core/detail/flow/moving_blocks.h"
#include "core/detail/prolong_guide.h"
#include "core/detail/resume_detail.h"
#include "core/detail/stamp/steepen_edges.h"
#include "core/fluid/conservative/tiles/round_to_quanta.h"
#include "core/fluid/scheme.h"

namespace pentimento {

namespace {
// After so many steps of rest a tile is searched for planes to free. Not at once, for strokes come
// back.
constexpr std::int64_t kRest = 32;

void zero_edges(PaintEdges& edges, const std::vector<conservative::Run>& runs) {
  for (auto* axis : {&edges.x, &edges.y})
    for (Field<float>& plane : *axis)
      for (const conservative::Run& run : runs)
        std::fill_n(plane.row(run.y) + run.x0, run.size(), 0.0f);
}
}  // namespace

DetailFollower::DetailFollower(DetailFollowerSetup setup, const DetailSubstrate& substrate,
                               TileStore& store, const Threads& threads)
    : setup_(std::move(setup)),
      threads_(threads),
      canvas_(DetailLayout(setup_.guide, setup_.factor), setup_.layers, setup_.channels,
              setup_.bands, substrate, store),
      stamp_(canvas_, setup_.amount, threads),
      lock_(canvas_.layout()),
      edges_(setup_.guide, setup_.layers),
      changed_(canvas_.layout()),
      reworked_(canvas_.layout()),
      stale_(canvas_.layout(), setup_.layers, setup_.channels),
      released_(canvas_.layout()),
      moving_(canvas_.layout()),
      locked_(static_cast<std::size_t>(canvas_.layout().tiles()), -1),
      touched_(static_cast<std::size_t>(canvas_.layout().tiles()), 1) {}

void DetailFollower::before_deposit(const StampPlan& plan, const CanvasState& guide) {
  // The detail canvas does the stamp later (stamp/queued_stamp.h).
  stamp_.before_deposit(plan, guide);
  const CellBox& box = stamp_.box();
  // The blocks under the stamp and the ring around them are locked at the end of the step.
  changed_.add({box.x0 - 1, box.x1 + 1, box.y0 - 1, box.y1 + 1});
  released_.stamped(box, plan.stamp.direction);
}

void DetailFollower::after_deposit(const StampPlan& plan, const CanvasState& guide) {
  stamp_.after_deposit(plan, guide);
}

void DetailFollower::moved(const CanvasState& guide, const StepInput& in,
                           const std::vector<conservative::Run>& runs) {
  stamp_.finish();
  // Where paint moved on the guide, and near enough to level.
  moving_.clear();
  add_moving(edges_, runs, moving_);
  const std::vector<int> tiles = moving_.tiles();
  if (tiles.empty()) return;
  // Paint may come to tiles that had none.
  for (const int t : tiles) canvas_.ensure_planes(t, guide, moving_.box(t));
  canvas_.give_memory(tiles, threads_);
  // The fine cells move with the guide's edges, one axis after the other as on the guide.
  const DetailAdvection move{in.model.pigment_residue, setup_.amount};
  const Axis first = edges_.x_first ? Axis::kX : Axis::kY;
  const Axis second = edges_.x_first ? Axis::kY : Axis::kX;
  for (const Axis axis : {first, second})
    advect_detail(canvas_, edges_, axis, moving_, move, threads_);
  // What moved evens out its own ripples.
  level_detail(canvas_, guide, edges_, in, moving_);
  // The lock looks at these blocks at the end of the step.
  for (const BlockStrip& strip : moving_.strips()) rework(strip);
  zero_edges(edges_, runs);
}

void DetailFollower::stepped(const CanvasState& guide, const StepInput& in) {
  stamp_.finish();
  // Stamps and motion are done: what they left is brought to what the guide holds.
  settle_released_paint(guide, in.model);
  add_rounded(in);
  ++steps_;
  if (!changed_.empty()) {
    // Tiles that changed: they have the planes that the guide's paint needs, and they rest no
    // longer.
    const std::vector<int> tiles = changed_.tiles();
    for (const int t : tiles) {
      canvas_.ensure_planes(t, guide, changed_.box(t));
      canvas_.mark_used(t);
      touched_[static_cast<std::size_t>(t)] = 1;
      std::int64_t& locked = locked_[static_cast<std::size_t>(t)];
      if (locked < 0) idle_.push_back(t);
      locked = steps_;
    }
    canvas_.give_memory(tiles, threads_);
    lock_changed(guide);
    changed_.clear();
    reworked_.clear();
    // Memory beyond the budget goes to the scratch file.
    canvas_.trim();
  }
  // Memory: planes of tiles at rest in which nothing is left.
  free_idle_planes(guide);
}

/// Adds the cells around the brush, for the guide has rounded all of them to whole quanta.
void DetailFollower::add_rounded(const StepInput& in) {
  const CellBox box = conservative::rounded_box(in.contact);
  if (!box.empty()) changed_.add({box.x0, box.x1, box.y0, box.y1});
}

/// Paint that the brush has released gets steep edges and levels. The lock then corrects these
/// blocks.
void DetailFollower::settle_released_paint(const CanvasState& guide, const Model& model) {
  const std::vector<ReleasedBlock> left = released_.step();
  steepen_edges(canvas_, guide, left, threads_);
  level_relief(canvas_, guide, left, model.surface_tension_N_m, threads_);
  for (const ReleasedBlock& block : left) rework(block.at);
}

/// Notes that the fine cells of blocks have changed.
void DetailFollower::rework(const BlockStrip& strip) {
  changed_.add(strip.y, strip.x0, strip.x1);
  reworked_.add(strip.y, strip.x0, strip.x1);
}

/// Locks what is stale of the blocks that changed.
void DetailFollower::lock_changed(const CanvasState& guide) {
  const std::vector<BlockStrip> stale = stale_.find(guide, changed_, reworked_, threads_);
  if (setup_.locked) lock_.lock(canvas_, guide, stale, threads_);
}

/// Frees wet planes in which nothing is left, of tiles that have rested for kRest steps.
void DetailFollower::free_idle_planes(const CanvasState& guide) {
  const auto rests = [&](int t) {
    std::int64_t& locked = locked_[static_cast<std::size_t>(t)];
    if (steps_ - locked < kRest) return false;
    canvas_.prune(t, guide);
    touched_[static_cast<std::size_t>(t)] = 1;
    locked = -1;
    return true;
  };
  std::erase_if(idle_, rests);
}

void DetailFollower::drying(const CanvasState&, const ChannelBasis& basis, const Model& model) {
  stamp_.finish();
  dry_detail(canvas_, basis, model, threads_);
  stale_.clear();
  touch_all();
}

void DetailFollower::cleared() {
  stamp_.forget();
  canvas_.clear();
  touch_all();
  for (const int t : idle_) locked_[static_cast<std::size_t>(t)] = -1;
  idle_.clear();
  changed_.clear();
  reworked_.clear();
  stale_.clear();
  released_.clear();
}

void DetailFollower::restored(const CanvasState& guide) {
  cleared();
  prolong_guide(canvas_, guide, threads_);
  // At its next step the guide rounds everything it holds to whole quanta, so every block may
  // change.
  for (int y = 0; y < setup_.guide.height; ++y) {
    changed_.add(y, 0, setup_.guide.width);
    reworked_.add(y, 0, setup_.guide.width);
  }
  lock_changed(guide);
}

/// Index in DetailCheckpoint::tile of the number that says how long a tile has rested.
std::size_t DetailFollower::rest_value(int tile) const {
  const int columns = kCheckpointPigment + canvas_.layers() * canvas_.channels();
  return static_cast<std::size_t>(tile) * static_cast<std::size_t>(columns) + kCheckpointRest;
}

DetailCheckpoint DetailFollower::checkpoint() const {
  DetailCheckpoint checkpoint = checkpoint_canvas(canvas_);
  for (const int t : idle_)
    checkpoint.tile[rest_value(t)] =
        static_cast<std::uint32_t>(1 + steps_ - locked_[static_cast<std::size_t>(t)]);
  checkpoint_changed(changed_, canvas_.layout(), checkpoint);
  checkpoint.stamped = released_.stamped();
  return checkpoint;
}

void DetailFollower::resume(const CanvasSource& fine, const DetailCheckpoint& checkpoint,
                            const CanvasState& guide) {
  cleared();
  resume_detail(canvas_, fine, checkpoint, guide);
  restore_notes(checkpoint, guide);
}

Result<void> DetailFollower::recall(const DetailCheckpoint& checkpoint,
                                    const LockStatistics& statistics, const CanvasState& guide,
                                    const PlaneReader& read) {
  cleared();
  if (Result<void> restored = restore_tiles(canvas_, checkpoint, read); !restored) return restored;
  restore_notes(checkpoint, guide);
  lock_.recall(statistics);
  return {};
}

std::vector<int> DetailFollower::touched() const {
  std::vector<int> tiles;
  for (int t = 0; t < canvas_.layout().tiles(); ++t)
    if (touched_[static_cast<std::size_t>(t)] != 0 || changed_.has(t)) tiles.push_back(t);
  return tiles;
}

/// How long tiles have rested, which blocks changed, where the brush was, and what the guide held.
void DetailFollower::restore_notes(const DetailCheckpoint& checkpoint, const CanvasState& guide) {
  steps_ = kRest;
  for (int t = 0; t < canvas_.layout().tiles(); ++t) {
    const std::int64_t rest = checkpoint.tile[rest_value(t)];
    if (rest == 0) continue;
    locked_[static_cast<std::size_t>(t)] = steps_ - std::min(rest - 1, kRest);
    idle_.push_back(t);
  }
  // Between two steps, blocks have changed only where the canvas was restored: all their cells.
  restore_changed(checkpoint, canvas_.layout(), changed_);
  for (const BlockStrip& strip : changed_.strips()) rework(strip);
  stale_.note(guide);
  released_.restore(checkpoint.stamped);
}

}  // namespace pentimento
