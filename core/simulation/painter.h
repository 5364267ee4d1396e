#pragma once
// The interface of a canvas that a painter's hand works on. The canvas may be the simulated one
// (core/simulation/simulation.h), or a map of where paint would be, from which time and memory are
// estimated. So a log is interpreted in one place (replay/play/hand.h), for both alike.

#include <cstdint>
#include <vector>

#include "core/base/field.h"
#include "core/base/vec.h"
#include "core/brush/brush_settings.h"
#include "core/brush/stamp.h"
#include "core/canvas/canvas_state.h"
#include "core/model/model.h"

namespace pentimento {

class Painter {
 public:
  virtual ~Painter() = default;

  // The hand: what the brush is, holds and does.
  /// Sets the sliders. If medium or pigment change, the brush is loaded afresh, as by a colour.
  virtual void set_settings(const BrushSettings& settings) = 0;
  /// Takes a brush. If it is another brush than the one in the hand, it is clean and dipped into
  /// the colour.
  virtual void set_brush(const BrushDefinition& brush) = 0;
  /// Loads every brush with `pigment` (an index into the palette the channels were made from).
  virtual void set_color(int pigment) = 0;
  /// Dips only the part [from, to] of the tip's width into `pigment`; 0 is the left side of a
  /// stroke, 1 the right. The rest of the tip keeps its paint.
  virtual void set_color(int pigment, float from, float to) = 0;
  /// A touch goes down. It has fresh fluid and a reservoir of its own, which is kept for its id
  /// until set_color().
  virtual void begin_stroke(int touch_id, std::uint32_t stroke_id) = 0;
  /// Says which stamp of the touch will probably follow on the one that is done next. It changes no
  /// result, only how soon the following one is done.
  virtual void expect(int /*touch_id*/, const Stamp& /*next*/) {}
  /// Does a stamp of a touch that is down.
  virtual void stamp(int touch_id, const Stamp& stamp) = 0;
  virtual void end_stroke(int touch_id) = 0;

  // The tablet and its controls.
  /// The reading of the accelerometer at the canvas, y down. Paint accelerates against it.
  virtual void set_gravity(Vec3f gravity_m_s2) = 0;
  /// Model parameters that may change while painting (all but `scheme` and `layers`).
  virtual void set_model(const Model& model) = 0;
  /// R20: all wet paint dries; velocities become 0.
  virtual void dry() = 0;
  /// Makes the canvas fresh: paper as at the start.
  virtual void clear() = 0;
  /// Makes the canvas fresh, with a picture as its dry layer: one plane of linear reflectance per
  /// band, of the grid's size.
  virtual void load(const std::vector<Field<float>>& reflectance) = 0;

  virtual const Model& model() const = 0;
  virtual const CanvasGeometry& geometry() const = 0;
};

}  // namespace pentimento
