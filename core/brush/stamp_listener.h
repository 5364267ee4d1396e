#pragma once
// The interface of anything that does each stamp again on a canvas of its own.

#include "core/brush/stamp_plan.h"
#include "core/canvas/canvas_state.h"

namespace pentimento {

class StampListener {
 public:
  virtual ~StampListener() = default;
  /// Called before a stamp that touches the canvas, while no other thread is at work.
  virtual void begin_stamp() = 0;
  /// Called once in each stamp, at any time and on any thread, so perhaps beside before_deposit()
  /// and after_deposit(). Of `plan` it may read where the stamp lies and the tip: stamp, tip, pose,
  /// extent, box and state.
  virtual void draw_tip(const StampPlan& plan) = 0;
  /// Called once per stamp, after the paint has been picked up from `canvas` and before any is
  /// deposited. The layers and stroke ids of `canvas` are still those before the stamp;
  /// `plan.reservoir` is what the stamp will sample.
  virtual void before_deposit(const StampPlan& plan, const CanvasState& canvas) = 0;
  /// Called after the stamp has deposited its paint, if it had any. `plan.reservoir` is still what
  /// the stamp sampled.
  virtual void after_deposit(const StampPlan& plan, const CanvasState& canvas) = 0;
  /// Called when all of the above is done, while no other thread is at work.
  virtual void end_stamp() = 0;
};

}  // namespace pentimento
