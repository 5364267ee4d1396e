#pragma once
// A canvas, a brush in the hand and the fluid under it: the whole model behind one facade (R36).
// The order within a step is the caller's for events, then: step(). One instance, one thread at a
// time; the loops inside use `threads`. Fully deterministic.

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/threads.h"
#include "core/base/vec.h"
#include "core/brush/brush_settings.h"
#include "core/brush/stamp.h"
#include "core/canvas/canvas_state.h"
#include "core/canvas/paint_account.h"
#include "core/fluid/scheme.h"
#include "core/model/model.h"
#include "core/optics/channels.h"
#include "core/simulation/canvas_listener.h"

namespace pentimento {

struct SimulationSetup {
  CanvasGeometry geometry;
  Model model;
  ChannelBasis basis;
  float dt_s = 1.0f / 45;
  Field<float> paper_m;  // relief of the paper on the grid, >= 0
  std::vector<float> paper_reflectance = {0.9f, 0.9f, 0.9f};  // per band of the basis
};

class Simulation {
 public:
  /// `threads` outlives the simulation.
  Simulation(SimulationSetup setup, const Threads& threads);
  ~Simulation();

  // The hand: what the brush is, holds and does.
  /// Sliders that change what the brush holds (medium, pigment) load it afresh, as a colour does.
  void set_settings(const BrushSettings& settings);
  /// Another brush than the one in the hand is a clean one, dipped into the colour.
  void set_brush(const BrushDefinition& brush);
  /// Loads every brush with `pigment` (an index into the palette the basis was made from).
  void set_color(int pigment);
  /// Dips only the part [from, to] of the tip's width into it, 0 the left side of a stroke and 1
  /// the right; the rest keeps what it holds.
  void set_color(int pigment, float from, float to);
  /// A touch goes down: fresh fluid density, its own reservoir (kept per touch id until set_color).
  void begin_stroke(int touch_id, std::uint32_t stroke_id);
  void stamp(int touch_id, const Stamp& stamp);
  void end_stroke(int touch_id);
  /// Told of everything that happens to the canvas; nullptr: nobody. Outlives the simulation.
  void set_listener(CanvasListener* listener);

  // The tablet and its controls.
  void set_gravity(Vec3f gravity_m_s2);
  /// Model parameters that may change while painting (all but `scheme` and `layers`).
  void set_model(const Model& model);
  /// R20: velocities to zero, the wet paint joins the dry layer.
  void dry();
  /// A fresh canvas: paper as at the start; the paint account starts anew.
  void clear();
  /// A fresh canvas with an image as its dry layer: one plane per band, linear reflectance, of the
  /// grid's size.
  void load(const std::vector<Field<float>>& reflectance);
  /// Goes on from a dumped state (same geometry, layers and channels). What is wet in it opens the
  /// paint account as deposited.
  void restore(CanvasState state);

  /// One simulation step. Returns false if it changed nothing and nothing waits: the caller may
  /// then skip steps with skip() until the next event, with the same result.
  bool step();
  void skip(std::int64_t steps);

  const CanvasState& state() const;
  const Model& model() const;
  const ChannelBasis& basis() const;
  const PaintAccount& account() const;
  /// What is wet on the canvas now.
  PaintFlow wet() const;
  /// First non-finite value, as "depth at cell (3,4)"; empty if all is finite.
  std::string first_non_finite() const;
  std::vector<std::pair<std::string, double>> statistics() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pentimento
