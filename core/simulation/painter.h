#pragma once
// What a painter's hand can do to a canvas, whatever that canvas is: the one that is simulated
// (core/simulation/simulation.h), or a map of where paint would be, from which time and memory are
// foreseen. So a log is understood in one place (replay/play/hand.h), and both take it alike.

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
  /// Sliders that change what the brush holds (medium, pigment) load it afresh, as a colour does.
  virtual void set_settings(const BrushSettings& settings) = 0;
  /// Another brush than the one in the hand is a clean one, dipped into the colour.
  virtual void set_brush(const BrushDefinition& brush) = 0;
  /// Loads every brush with `pigment` (an index into the palette the channels were made from).
  virtual void set_color(int pigment) = 0;
  /// Dips only the part [from, to] of the tip's width into it, 0 the left side of a stroke and 1
  /// the right; the rest keeps what it holds.
  virtual void set_color(int pigment, float from, float to) = 0;
  /// A touch goes down: fresh fluid density, its own brush (kept per touch id until set_color).
  virtual void begin_stroke(int touch_id, std::uint32_t stroke_id) = 0;
  /// Of a touch that is down.
  virtual void stamp(int touch_id, const Stamp& stamp) = 0;
  virtual void end_stroke(int touch_id) = 0;

  // The tablet and its controls.
  /// What the sensor at the canvas reads, y down: paint accelerates against it.
  virtual void set_gravity(Vec3f gravity_m_s2) = 0;
  /// Model parameters that may change while painting (all but `scheme` and `layers`).
  virtual void set_model(const Model& model) = 0;
  /// R20: velocities to zero, the wet paint joins the dry layer.
  virtual void dry() = 0;
  /// A fresh canvas: paper as at the start.
  virtual void clear() = 0;
  /// A fresh canvas with an image as its dry layer: one plane per band, linear reflectance, of the
  /// grid's size.
  virtual void load(const std::vector<Field<float>>& reflectance) = 0;

  virtual const Model& model() const = 0;
  virtual const CanvasGeometry& geometry() const = 0;
};

}  // namespace pentimento
