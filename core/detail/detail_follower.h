#pragma once
// The detail follower does on the detail canvas what happens on the guide: the same stamps, the
// same flow, and the lock after each step. The guide does not depend on it, so a log gives one
// sequence of states, whatever the output's size.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/base/threads.h"
#include "core/canvas/canvas_source.h"
#include "core/detail/lock/lock.h"
#include "core/detail/lock/stale_blocks.h"
#include "core/detail/stamp/detail_stamp.h"
#include "core/detail/store/changed_blocks.h"
#include "core/detail/store/detail_canvas.h"
#include "core/detail/store/detail_checkpoint.h"
#include "core/detail/store/released_blocks.h"
#include "core/detail/store/tile_planes.h"
#include "core/simulation/canvas_listener.h"

namespace pentimento {

struct DetailFollowerSetup {
  CanvasGeometry guide;
  int factor = 1;  // 1..kMostDetail
  int layers = 1;
  int channels = 0;
  int bands = 3;
  std::vector<float> amount;  // per channel: its share in the total amount (A26)
  bool locked = true;         // false only to measure what the lock does
};

class DetailFollower : public CanvasListener {
 public:
  /// `substrate`, `store` and `threads` must outlive the follower. A buffer of `store` has
  /// DetailLayout::side() squared floats.
  DetailFollower(DetailFollowerSetup setup, const DetailSubstrate& substrate, TileStore& store,
                 const Threads& threads);

  void begin_stamp() override { stamp_.begin(); }
  void draw_tip(const StampPlan& plan) override { stamp_.draw_tip(plan); }
  void before_deposit(const StampPlan& plan, const CanvasState& guide) override;
  void after_deposit(const StampPlan& plan, const CanvasState& guide) override;
  void end_stamp() override { stamp_.add_touched(reworked_); }
  PaintEdges& edges() override { return edges_; }
  void moved(const CanvasState& guide, const StepInput& in,
             const std::vector<conservative::Run>& runs) override;
  void stepping() override { stamp_.start(); }
  void stepped(const CanvasState& guide, const StepInput& in) override;
  void drying(const CanvasState& guide, const ChannelBasis& basis, const Model& model) override;
  void cleared() override;
  void restored(const CanvasState& guide) override;

  /// Goes on from a dump, as if the replay had never stopped. `fine`: the planes of the detail
  /// canvas; `checkpoint`: the result of checkpoint() at the dump; `guide`: the guide's state at
  /// the dump. The detail canvas must be clear.
  void resume(const CanvasSource& fine, const DetailCheckpoint& checkpoint,
              const CanvasState& guide);
  /// All that a dump needs beside the planes of canvas(). Call finish_stamps() first.
  DetailCheckpoint checkpoint() const;

  /// Goes on with the notes that checkpoint() and lock_statistics() gave, and with planes that
  /// equal those of that canvas. `guide`: the guide's state then. The detail canvas must be clear.
  /// Errors: those of `read`; canvas().problem().
  Result<void> recall(const DetailCheckpoint& checkpoint, const LockStatistics& statistics,
                      const CanvasState& guide, const PlaneReader& read);
  /// The tiles whose planes may have other values, or may not exist any more, since the last call
  /// of forget_touched(), ascending. At first all tiles. Call finish_stamps() first.
  std::vector<int> touched() const;
  void forget_touched() { std::fill(touched_.begin(), touched_.end(), std::uint8_t{0}); }

  /// Does the queued stamps, so that canvas() has every stamp.
  void finish_stamps() { stamp_.finish(); }
  const DetailCanvas& canvas() const { return canvas_; }
  const LockStatistics& lock_statistics() const { return lock_.statistics(); }

 private:
  void restore_notes(const DetailCheckpoint& checkpoint, const CanvasState& guide);
  void touch_all() { std::fill(touched_.begin(), touched_.end(), std::uint8_t{1}); }
  void settle_released_paint(const CanvasState& guide, const Model& model);
  void add_rounded(const StepInput& in);
  void rework(const BlockStrip& strip);
  void lock_changed(const CanvasState& guide);
  void free_idle_planes(const CanvasState& guide);
  std::size_t rest_value(int tile) const;

  DetailFollowerSetup setup_;
  const Threads& threads_;
  DetailCanvas canvas_;
  DetailStamp stamp_;
  Lock lock_;
  PaintEdges edges_;
  ChangedBlocks changed_;   // blocks changed since the last lock, and their neighbours
  ChangedBlocks reworked_;  // those of them whose fine cells changed
  StaleBlocks stale_;
  ReleasedBlocks released_;
  ChangedBlocks moving_;  // blocks where paint moves in this part of a step
  // In which step each tile was last locked; tiles locked since they were last searched for planes
  // to free.
  std::int64_t steps_ = 0;
  std::vector<std::int64_t> locked_;
  std::vector<int> idle_;
  std::vector<std::uint8_t> touched_;  // per tile, but for what is in `changed_`
};

}  // namespace pentimento
