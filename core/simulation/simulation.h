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
#include "core/brush/tip_rack.h"
#include "core/canvas/canvas_state.h"
#include "core/canvas/paint_account.h"
#include "core/fluid/scheme.h"
#include "core/model/model.h"
#include "core/optics/channels.h"
#include "core/simulation/canvas_listener.h"
#include "core/simulation/painter.h"
#include "core/simulation/simulation_memory.h"

namespace pentimento {

struct SimulationSetup {
  CanvasGeometry geometry;
  Model model;
  ChannelBasis basis;
  float dt_s = 1.0f / 45;
  Field<float> paper_m;  // relief of the paper on the grid, >= 0
  std::vector<float> paper_reflectance = {0.9f, 0.9f, 0.9f};  // per band of the basis
  /// Where the tips of brushes are kept once they are drawn. Simulations that share a rack draw
  /// each tip once; nullptr: the simulation has a rack of its own, which its forks share.
  std::shared_ptr<TipRack> tips = nullptr;
};

class Simulation : public Painter {
 public:
  /// `threads` outlives the simulation.
  Simulation(SimulationSetup setup, const Threads& threads);
  ~Simulation() override;

  void set_settings(const BrushSettings& settings) override;
  void set_brush(const BrushDefinition& brush) override;
  void set_color(int pigment) override;
  void set_color(int pigment, float from, float to) override;
  void begin_stroke(int touch_id, std::uint32_t stroke_id) override;
  void expect(int touch_id, const Stamp& next) override;
  void stamp(int touch_id, const Stamp& stamp) override;
  void end_stroke(int touch_id) override;
  void set_gravity(Vec3f gravity_m_s2) override;
  void set_model(const Model& model) override;
  void dry() override;
  /// The paint account starts anew; so it does with load().
  void clear() override;
  void load(const std::vector<Field<float>>& reflectance) override;
  const Model& model() const override;
  const CanvasGeometry& geometry() const override;

  /// Told of everything that happens to the canvas; nullptr: nobody. Outlives the simulation.
  void set_listener(CanvasListener* listener);

  /// Another simulation that is at the same point and goes on bit for bit as this one would:
  /// canvas, brushes and the paint in them, account. It has no listener. Call it between steps.
  /// `threads` outlives it.
  std::unique_ptr<Simulation> fork(const Threads& threads) const;

  /// Goes on from a dumped state (same geometry, layers and channels). What is wet in it opens the
  /// paint account as deposited.
  void restore(CanvasState state);

  /// All that must be saved between two steps beside state(), if the hand's settings (brush,
  /// sliders, colours, gravity, model) are brought back by doing the same again.
  SimulationMemory memory() const;
  /// Whether `memory` can be that of a simulation with this one's setup.
  bool fits(const SimulationMemory& memory) const;
  /// Goes on as the simulation would that had this state and memory between two steps. This one has
  /// the same setup, and its hand did the same; the memory fits. The paper stays this one's; the
  /// listener is not told.
  void recall(CanvasState state, const SimulationMemory& memory);

  /// One simulation step. Returns false if it changed nothing and nothing waits: the caller may
  /// then skip steps with skip() until the next event, with the same result.
  bool step();
  void skip(std::int64_t steps);

  const CanvasState& state() const;
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
