#pragma once
// The fluid scheme of the publication (Stuyck, Da, Hadap, Dutre, Real-Time Oil Painting on Mobile
// Hardware, 2016): R5-R19 on a collocated grid, in plain loops. It reproduces the paper, and the
// other scheme's speed is measured against it. docs/paper-scheme.md tells its clamps and what they
// lose.

#include "core/fluid/paper/planes.h"
#include "core/fluid/paper/step_constants.h"
#include "core/fluid/scheme.h"

namespace pentimento::paper {

class PaperScheme : public FluidScheme {
 public:
  PaperScheme(const CanvasGeometry& geometry, int layers, int channels);

  /// Does one step: brush velocity, rheology, trace, height, gravity, viscosity, limits, depth,
  /// pigment. The cost is in proportion to the area between the first and the last painted cell of
  /// each row. Stroke ids do not move with the paint: a cell keeps the id of the last stroke that
  /// touched it.
  bool step(CanvasState& state, const StepInput& in) override;

  /// max_speed_m_s: the fastest cell so far; live_frac: mean share of the canvas computed per step.
  std::vector<std::pair<std::string, double>> statistics() const override;
  std::vector<double> memory() const override;
  bool fits(std::span<const double> memory) const override;
  void recall(std::span<const double> memory) override;

 private:
  void prepare(CanvasState& state, const StepInput& in);
  const Field<float>& solve_height(const CanvasState& state, const StepInput& in);
  /// Returns the index of the velocity buffer that holds the result.
  std::size_t solve_velocity(const CanvasState& state, const StepInput& in,
                             const Field<float>& height_m);
  /// Finds the rectangle that paint can have come from or got to in this step.
  void find_travel(const CanvasState& state);
  /// Finds what of the bottom layer is free to move, and counts layers.
  void weigh_layers(const CanvasState& state, const StepInput& in, int y, Columns cells);
  void advect_pigment(CanvasState& state, const StepInput& in, std::size_t velocity);
  /// Gives the state a layer's pigment where it has gone to.
  void store_layer(CanvasState& state, const StepInput& in, int layer, bool mostly_flows);
  template <typename Body>
  void for_live_rows(const StepInput& in, Body body) const;
  /// Calls body(stage, y, cells) for all stages of all live rows, in the order of for_sweeps().
  template <typename Body>
  void for_stages_of_rows(const StepInput& in, int stages, Body body) const;
  template <typename Body>
  void for_travel_rows(const StepInput& in, Body body) const;
  void finish_row(const CanvasState& state, const StepInput& in, std::size_t velocity, int y);
  /// Lets fronts advance and stores the velocity.
  void store_velocity(CanvasState& state, const StepInput& in, std::size_t velocity);
  /// Stores the velocity of row y. Returns whether any bit changed.
  bool settle_row(CanvasState& state, const StepInput& in, std::size_t velocity, int y);
  float fastest_m_s() const;

  StepConstants constants_{};
  Planes planes_;
  LiveRows rows_;
  std::vector<std::uint8_t> row_changed_;
  std::vector<Columns> row_flow_;  // where the new velocity is not 0
  std::vector<float> row_speed2_;  // the largest square of its speed, (m/s)^2
  Columns travel_columns_, travel_rows_;
  int travel_cells_ = 0;   // the fastest paint's travel, rounded up; 0 when all stands
  bool may_move_ = false;  // paint moved in the last step, or a brush moves it
  double max_speed_m_s_ = 0;
  double live_frac_sum_ = 0;
  std::int64_t steps_ = 0;
};

}  // namespace pentimento::paper
