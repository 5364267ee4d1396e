#pragma once
// The fluid scheme that loses no paint. Its velocities are staggered, paint and momentum move by
// forward remap, viscosity and pressure are solved implicitly by multigrid, the bed rubs, and tiles
// sleep. docs/numerics.md has the stages of a step, by the numbers that the comments here use, and
// says where the scheme departs from the paper and why.
//
// A step is cut into equal parts if paint would come further than Model::most_cells_moved cells in
// one. The reason: the pressure uses the face depths at the start of a part, and a front that
// crosses several cells meanwhile breaks up into drops.
//
// velocity_x_m_s(i, j) lives on the right face of cell (i, j), velocity_y_m_s(i, j) on its lower
// face. The last column and the last row are walls: their velocity is 0.

#include <functional>
#include <memory>
#include <utility>

#include "core/fluid/conservative/solve/height_row.h"
#include "core/fluid/conservative/solve/workspace.h"
#include "core/fluid/conservative/step_report.h"
#include "core/fluid/conservative/tiles/live_tiles.h"
#include "core/fluid/conservative/tiles/resting_tiles.h"
#include "core/fluid/conservative/tiles/sleep_tiles.h"
#include "core/fluid/conservative/tiles/wet_cells.h"
#include "core/fluid/scheme.h"

namespace pentimento::conservative {

class ConservativeScheme : public FluidScheme {
 public:
  explicit ConservativeScheme(const CanvasGeometry& geometry);

  bool step(CanvasState& state, const StepInput& in) override;
  std::vector<std::pair<std::string, double>> statistics() const override {
    return report_.statistics();
  }
  std::vector<double> memory() const override;
  bool fits(std::span<const double> memory) const override;
  void recall(std::span<const double> memory) override;
  /// Share of the tiles that were awake in the last step.
  double awake_share() const { return tiles_ ? tiles_->awake_share() : 0; }
  /// From the next step on computes bare cells of awake tiles, too: the same bits, in more time.
  /// For tests.
  void leave_nothing_out() { leaves_out_ = false; }
  /// `done` is called after each pass of a step with the pass's name. For measuring.
  void on_pass(std::function<void(const char* pass)> done) { passed_ = std::move(done); }

 private:
  void passed(const char* pass) const {
    if (passed_) passed_(pass);
  }
  void find_live(const StepInput& in);
  void find_wet(CanvasState& state, const StepInput& in, float travel_cells);
  void make_tiles(float sleep_tile_m);
  void give_back();
  void part_of_step(CanvasState& state, const StepInput& in, int part);
  void advect(CanvasState& state, const StepInput& in, bool even);
  void rest_nodes(const Threads& threads);
  void apply_viscosity(const CanvasState& state, const StepInput& in);
  void solve_height(CanvasState& state, const StepInput& in);
  // These work on one run:
  void find_rheology(const CanvasState& state, const StepInput& in, const Run& r);
  void find_faces(const CanvasState& state, const StepInput& in, const Run& r);
  void pin_edges(const CanvasState& state, const StepInput& in);
  FluxRow fluxes(const Run& r) const;
  void foresee_surface(const CanvasState& state, const StepInput& in, const Run& r);
  void copy_sleeping_neighbours(const CanvasState& state);
  void find_films(const CanvasState& state, const Run& r);
  void forget_sleeping_films(const Run& r);
  void apply_gravity(const CanvasState& state, const StepInput& in, const Run& r);
  void find_crowding(const CanvasState& state, const StepInput& in, const Run& r);
  void apply_tension(const CanvasState& state, const StepInput& in, const Run& r);
  void fill_height(const CanvasState& state, const StepInput& in, const Run& r);
  void finish(const StepInput& in, const Run& r);
  void stand(CanvasState& state, const StepInput& in, const Run& r) const;

  CanvasGeometry geometry_;
  std::unique_ptr<SleepTiles> tiles_;  // made at the first step: their size is a parameter
  float sleep_tile_m_ = 0;             // that parameter then; 0 before the first step
  LiveTiles live_;                     // of this step
  WetCells wet_;                       // of this part of a step
  std::vector<Run> live_runs_;         // wet cells of live tiles
  std::vector<Run> wet_before_;        // those of the part before; outside, planes hold zeros
  bool knows_before_ = false;          // whether there was a part before
  bool leaves_out_ = true;             // bare cells
  RestingTiles resting_;               // used on large canvases
  Workspace work_;
  std::function<void(const char*)> passed_;
  BrushContact untouched_;  // of no size: the brush touches nothing in the later parts of a step
  StepReport report_;
};

}  // namespace pentimento::conservative
