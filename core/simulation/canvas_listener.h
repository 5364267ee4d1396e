#pragma once
// The interface of a listener that keeps a canvas of its own in step with the simulation's. It is
// told of everything that changes paint, in the order of the changes. It may read the simulation's
// state, but not change it.

#include "core/brush/stamp_listener.h"
#include "core/fluid/paint_edges.h"
#include "core/model/model.h"
#include "core/optics/channels.h"

namespace pentimento {

struct StepInput;

class CanvasListener : public StampListener, public AdvectionListener {
 public:
  /// A step begins: no stamp comes until it is over.
  virtual void stepping() {}
  /// A step is over; `state` is what it left.
  virtual void stepped(const CanvasState& state, const StepInput& in) = 0;
  /// All wet paint of `state` is about to dry.
  virtual void drying(const CanvasState& state, const ChannelBasis& basis, const Model& model) = 0;
  /// The canvas is fresh now; its substrate may be another one.
  virtual void cleared() = 0;
  /// The canvas became `state` by other means than painting.
  virtual void restored(const CanvasState& state) = 0;
};

}  // namespace pentimento
