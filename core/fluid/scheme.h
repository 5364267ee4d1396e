#pragma once
// The interface of a fluid scheme: one step of R5-R19 on a canvas that the brush has already
// stamped. There are two schemes: paper/ (the publication, R6-R18 to the letter) and conservative/.
// Brush, layers, drying and optics are shared and do not depend on the scheme.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/threads.h"
#include "core/base/vec.h"
#include "core/canvas/canvas_state.h"
#include "core/fluid/brush_contact.h"
#include "core/fluid/paint_edges.h"
#include "core/model/model.h"

namespace pentimento {

struct StepInput {
  const Model& model;
  Vec3f gravity_m_s2;  // in core's frame, y down; see below
  float dt_s;
  const BrushContact& contact;
  const std::vector<float>& amount;  // per channel: share in the total amount (m of A26)
  const Threads& threads;
  AdvectionListener* listener = nullptr;  // is told how paint moves; nullptr: nobody is
  // Whether the canvas was made or dried since the last step: no paint is wet but what the contact
  // has left, and nothing moves.
  bool fresh = false;
};
// gravity_m_s2 is what an accelerometer reads (specific force), so paint accelerates AGAINST it:
// u_t = -g_x. A tablet held upright reads (0,+9.81,0) with y up, which is (0,-9.81,0) in core's
// frame, and paint accelerates downwards with 9.81 m/s^2.

class FluidScheme {
 public:
  virtual ~FluidScheme() = default;
  /// Does one step. Returns whether any bit of the state changed (velocity, depth or pigment). If
  /// none did, and nothing changes from outside, further steps change nothing either and may be
  /// skipped.
  virtual bool step(CanvasState& state, const StepInput& in) = 0;
  /// Named measurements since the start, for reports ("max_speed_m_s", "awake_share", ...).
  virtual std::vector<std::pair<std::string, double>> statistics() const { return {}; }
  /// What the scheme keeps from step to step beside the state: sums behind statistics(), and what
  /// it fixed at its first step.
  virtual std::vector<double> memory() const = 0;
  /// Whether `memory` is that of such a scheme.
  virtual bool fits(std::span<const double> memory) const = 0;
  /// A new scheme goes on with the memory of another on the same canvas, which fits.
  virtual void recall(std::span<const double> memory) = 0;
};

}  // namespace pentimento
