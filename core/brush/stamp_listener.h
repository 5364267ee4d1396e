#pragma once
// Whoever does each stamp again on a canvas of its own.

#include "core/brush/stamp_plan.h"
#include "core/canvas/canvas_state.h"

namespace pentimento {

class StampListener {
 public:
  virtual ~StampListener() = default;
  /// Once per stamp, just before it lays: the paint has been lifted from `canvas`, whose layers and
  /// stroke ids are still those before; `plan.reservoir` is what will be sampled.
  virtual void before_deposit(const StampPlan& plan, const CanvasState& canvas) = 0;
  /// The stamp has laid its paint, if it had any; `plan.reservoir` still is what was sampled.
  virtual void after_deposit(const StampPlan& plan, const CanvasState& canvas) = 0;
};

}  // namespace pentimento
