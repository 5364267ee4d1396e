#pragma once
// The interface of anything that does each stamp again on a canvas of its own.

#include "core/brush/stamp_plan.h"
#include "core/canvas/canvas_state.h"

namespace pentimento {

class StampListener {
 public:
  virtual ~StampListener() = default;
  /// Called once per stamp, after the paint has been picked up from `canvas` and before any is
  /// deposited. The layers and stroke ids of `canvas` are still those before the stamp;
  /// `plan.reservoir` is what the stamp will sample.
  virtual void before_deposit(const StampPlan& plan, const CanvasState& canvas) = 0;
  /// Called after the stamp has deposited its paint, if it had any. `plan.reservoir` is still what
  /// the stamp sampled.
  virtual void after_deposit(const StampPlan& plan, const CanvasState& canvas) = 0;
};

}  // namespace pentimento
