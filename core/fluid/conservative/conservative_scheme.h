#pragma once
// The fluid that loses no paint: staggered velocities, forward remap of paint and momentum,
// implicit viscosity and pressure by multigrid, bed friction, sleeping tiles. What it departs from
// in the paper, and why, is in docs/numerics.md.
//
// A step is cut into equal parts where paint would come further than Model::most_cells_moved in
// one: the face depths of the pressure are those at the start of a part, and a front that moves
// through several cells meanwhile breaks up into drops (docs/numerics.md).
//
// velocity_x_m_s(i, j) lives on the right face of cell (i, j), velocity_y_m_s(i, j) on its lower
// face; the last column and row are walls and hold 0.

#include <functional>
#include <memory>
#include <utility>

#include "core/fluid/conservative/solve/workspace.h"
#include "core/fluid/conservative/tiles/sleep_tiles.h"
#include "core/fluid/scheme.h"

namespace pentimento::conservative {

class ConservativeScheme : public FluidScheme {
 public:
  explicit ConservativeScheme(const CanvasGeometry& geometry);

  bool step(CanvasState& state, const StepInput& in) override;
  std::vector<std::pair<std::string, double>> statistics() const override;
  /// Share of the tiles that were awake in the last step.
  double awake_share() const { return tiles_ ? tiles_->awake_share() : 0; }
  /// Called after each pass of a step with its name; for measuring.
  void on_pass(std::function<void(const char* pass)> done) { passed_ = std::move(done); }

 private:
  void passed(const char* pass) const {
    if (passed_) passed_(pass);
  }
  void part_of_step(CanvasState& state, const StepInput& in, int part);
  void transport(CanvasState& state, const StepInput& in, bool even);
  void apply_viscosity(const CanvasState& state, const StepInput& in);
  void solve_height(CanvasState& state, const StepInput& in);
  // On the run of a row:
  void find_rheology(const CanvasState& state, const StepInput& in, const Run& r);
  void find_faces(const CanvasState& state, const StepInput& in, const Run& r);
  void pin_edges(const CanvasState& state, const StepInput& in);
  void apply_forces(const StepInput& in, const Run& r);
  void fill_height(const CanvasState& state, const StepInput& in, const Run& r);
  void fill_pressure(const CanvasState& state, const StepInput& in, const Run& r);
  void finish(CanvasState& state, const StepInput& in, const Run& r);
  bool feels_gravity(const CellBox& box) const;
  void account(const CanvasState& state, const StepInput& in);

  CanvasGeometry geometry_;
  std::unique_ptr<SleepTiles> tiles_;  // made at the first step: their size is a parameter
  Workspace work_;
  std::function<void(const char*)> passed_;
  BrushContact untouched_;  // of no size: nothing is touched
  double steps_ = 0;
  double awake_share_sum_ = 0;
  double awake_share_max_ = 0;
  double speed_max_m_s_ = 0;
  double depth_max_m_ = 0;
};

}  // namespace pentimento::conservative
