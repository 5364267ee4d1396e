#pragma once
// The detail canvas in step with the guide: the same stamps, the same flow, locked after each step.
// The guide does not know of it, so a log has one trajectory, whatever the output's size.

#include <cstdint>
#include <vector>

#include "core/base/threads.h"
#include "core/canvas/canvas_source.h"
#include "core/detail/lock/lock.h"
#include "core/detail/stamp/detail_stamp.h"
#include "core/detail/store/changed_blocks.h"
#include "core/detail/store/detail_canvas.h"
#include "core/detail/store/detail_checkpoint.h"
#include "core/detail/store/released_blocks.h"
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
  /// `substrate`, `store` (DetailLayout::side() squared floats a buffer) and `threads` outlive it.
  DetailFollower(DetailFollowerSetup setup, const DetailSubstrate& substrate, TileStore& store,
                 const Threads& threads);

  void before_deposit(const StampPlan& plan, const CanvasState& guide) override;
  void after_deposit(const StampPlan& plan, const CanvasState& guide) override;
  PaintEdges& edges() override { return edges_; }
  void moved(const CanvasState& guide, const StepInput& in,
             const std::vector<conservative::Run>& runs) override;
  void stepped(const CanvasState& guide, const StepInput& in) override;
  void drying(const CanvasState& guide, const ChannelBasis& basis, const Model& model) override;
  void cleared() override;
  void restored(const CanvasState& guide) override;

  /// The canvas is clear and becomes one that was dumped: its planes, what its refinement's
  /// checkpoint() said then, and the guide that goes with them. As if nothing had happened.
  void resume(const CanvasSource& fine, const DetailCheckpoint& checkpoint,
              const CanvasState& guide);
  /// What canvas() does not tell, once its stamps are finished.
  DetailCheckpoint checkpoint() const;

  /// Does what still waits to be done: from then on canvas() has every stamp.
  void finish_stamps() { stamp_.finish(); }
  const DetailCanvas& canvas() const { return canvas_; }
  const LockStatistics& lock_statistics() const { return lock_.statistics(); }

 private:
  void steepen_released_edges(const CanvasState& guide);
  void add_rounded(const StepInput& in);
  void free_idle_planes(const CanvasState& guide);
  std::size_t rest_value(int tile) const;

  DetailFollowerSetup setup_;
  const Threads& threads_;
  DetailCanvas canvas_;
  DetailStamp stamp_;
  Lock lock_;
  PaintEdges edges_;
  ChangedBlocks changed_;  // since the last lock, and their neighbours
  ReleasedBlocks released_;
  ChangedBlocks moving_;  // in this part of a step
  // When each tile was last locked; tiles locked since they were last looked through.
  std::int64_t steps_ = 0;
  std::vector<std::int64_t> locked_;
  std::vector<int> idle_;
};

}  // namespace pentimento
