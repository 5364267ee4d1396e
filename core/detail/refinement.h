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
#include "core/detail/store/detail_notes.h"
#include "core/detail/store/left_blocks.h"
#include "core/simulation/canvas_follower.h"

namespace pentimento {

struct RefinementSetup {
  CanvasGeometry guide;
  int factor = 1;  // 1..kMostDetail
  int layers = 1;
  int channels = 0;
  int bands = 3;
  std::vector<float> amount;  // per channel: its share in the total amount (A26)
  bool locked = true;         // false only to measure what the lock does
};

class Refinement : public CanvasFollower {
 public:
  /// `ground`, `store` (DetailLayout::side() squared floats a block) and `threads` outlive it.
  Refinement(RefinementSetup setup, const DetailGround& ground, TileStore& store,
             const Threads& threads);

  void lay(const StampPlan& plan, const CanvasState& guide) override;
  void laid(const StampPlan& plan, const CanvasState& guide) override;
  PaintEdges& edges() override { return edges_; }
  void moved(const CanvasState& guide, const StepInput& in,
             const std::vector<conservative::Run>& runs) override;
  void stepped(const CanvasState& guide, const StepInput& in) override;
  void drying(const CanvasState& guide, const ChannelBasis& basis, const Model& model) override;
  void cleared() override;
  void restored(const CanvasState& guide) override;

  /// The canvas is clear and becomes one that was dumped: its planes, what its refinement's notes()
  /// said then, and the guide that goes with them. As if nothing had happened.
  void resume(const CanvasSource& fine, const DetailNotes& notes, const CanvasState& guide);
  /// What canvas() does not tell, once settled.
  DetailNotes notes() const;

  /// Does what still waits to be done: from then on canvas() has every stamp.
  void settle() { stamp_.finish(); }
  const DetailCanvas& canvas() const { return canvas_; }
  const LockStatistics& lock_statistics() const { return lock_.statistics(); }

 private:
  void gather_left_edges(const CanvasState& guide);
  void add_settled(const StepInput& in);
  void free_idle_planes(const CanvasState& guide);
  std::size_t noted_rest(int tile) const;

  RefinementSetup setup_;
  const Threads& threads_;
  DetailCanvas canvas_;
  DetailStamp stamp_;
  Lock lock_;
  PaintEdges edges_;
  ChangedBlocks changed_;  // since the last lock, and their neighbours
  LeftBlocks left_;
  ChangedBlocks moving_;  // in this part of a step
  // When each tile was last locked; tiles locked since they were last looked through.
  std::int64_t steps_ = 0;
  std::vector<std::int64_t> locked_;
  std::vector<int> idle_;
};

}  // namespace pentimento
