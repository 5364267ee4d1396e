#pragma once
// Sleep: the canvas is cut into sleep tiles of a fixed size in metres, and a tile at rest is left
// alone until something disturbs it. Sleep is part of the model, not a shortcut: a sleeping tile is
// a closed wall to its neighbours, and nothing in it changes.
//
// A tile falls asleep if all its velocities were 0 at the start and at the end of a step and no
// brush touched it in the step. It wakes when
//  - the brush touches it, or pushes paint within reach of it;
//  - paint moves, in a tile awake, within reach of it: as far as that paint comes in one step, and
//    two cells more, so that no slope can build up against a closed wall unseen;
//  - gravity differs, in any component, by Model::wake_gravity_m_s2 or more from what it was when
//    the tile fell asleep, unless all its paint is too thin or too stiff to feel gravity.
//
// What sleeps is kept in CanvasState::sleep. If it is emptied, everything wakes, but on a fresh
// canvas: that sleeps where the brush has not touched it.

#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/runs.h"
#include "core/canvas/canvas_state.h"
#include "core/canvas/cell_box.h"
#include "core/fluid/scheme.h"

namespace pentimento::conservative {

/// Memory of one tile in CanvasState::sleep, tile after tile, row by row: whether it sleeps (0 or
/// 1), gravity when it fell asleep (m/s^2, y down), whether any of its paint feels gravity.
enum SleepValue { kAsleep, kGravityX, kGravityY, kGravityZ, kFeelsGravity, kSleepValues };

class SleepTiles {
 public:
  /// Each side of a tile is a power of two of cells, at least 8: the largest that is not longer
  /// than `tile_m`, or the smallest that covers the canvas if that is less.
  SleepTiles(const CanvasGeometry& geometry, float tile_m);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  int count() const { return columns_ * rows_; }
  int tile_width() const { return tile_width_; }
  int tile_height() const { return tile_height_; }
  CellBox box(int tile) const;
  bool awake(int column, int row) const {
    return awake_[static_cast<std::size_t>(row * columns_ + column)] != 0;
  }
  /// How far the fastest awake paint comes in one step, in cells. Known after wake().
  float travel_cells() const { return travel_cells_; }
  /// What the brush touches, and what it may push paint to. Known after wake().
  const CellBox& touched() const { return touched_; }
  /// Whether any paint moves at the start of the step. Known after wake().
  bool moves() const { return moves_; }
  double awake_share() const { return static_cast<double>(list_.size()) / count(); }
  const std::vector<int>& awake_tiles() const { return list_; }
  /// Whether any paint of a tile moves at the start of the step. Known after wake().
  bool moves(int tile) const { return moving_[static_cast<std::size_t>(tile)] != 0; }

  /// Decides which tiles are awake in this step.
  void wake(const CanvasState& state, const StepInput& in);
  /// Writes into the sleep of a fresh canvas (StepInput::fresh) what a step that computed all tiles
  /// would write for those that wake() has left asleep.
  void rest_fresh(CanvasState& state, const StepInput& in) const;
  /// Call it after the step: writes into `state.sleep` which tiles fall asleep.
  /// `feels_gravity(box)` says whether any paint in a tile's box feels gravity.
  void fall_asleep(CanvasState& state, const StepInput& in,
                   const std::function<bool(const CellBox&)>& feels_gravity);

  /// The cells of awake tiles: as runs, and as strips, which are columns of tiles, one tile wide.
  const std::vector<Run>& runs() const { return runs_; }
  const std::vector<CellBox>& strips() const { return strips_; }
  /// Calls body(x0, x1) for the cells [x0, x1) of run `r` whose lower face is open: the cell below
  /// is awake.
  template <typename Body>
  void for_open_below(const Run& r, const Body& body) const {
    const int below = (r.y + 1) / tile_height_;
    if (r.y + 1 >= height_) return;
    if (below == r.y / tile_height_) return body(r.x0, r.x1);
    for (int c = r.x0 / tile_width_; c * tile_width_ < r.x1; ++c)
      if (awake(c, below))
        body(std::max(c * tile_width_, r.x0), std::min((c + 1) * tile_width_, r.x1));
  }
  /// Calls body(x0, x1) for the cells [x0, x1) beside run `r` in row y, above or below it, that
  /// sleep. Row y may lie beyond the canvas.
  template <typename Body>
  void for_sleeping_beside(const Run& r, int y, const Body& body) const {
    if (y < 0 || y >= height_ || y / tile_height_ == r.y / tile_height_) return;
    for (int c = r.x0 / tile_width_; c * tile_width_ < r.x1; ++c)
      if (!awake(c, y / tile_height_))
        body(std::max(c * tile_width_, r.x0), std::min((c + 1) * tile_width_, r.x1));
  }

 private:
  /// Where in a tile paint moves, and how far it comes in one step.
  struct Motion {
    CellBox box;                       // cells on either side of a moving face
    float travel_x = 0, travel_y = 0;  // cells
    void add(int x, int y, float cells_x, float cells_y);
  };
  Motion flow_in(const CanvasState& state, int tile, float dt_s) const;
  Motion touch_in(const BrushContact& contact, int tile) const;
  void wake_around(const Motion& motion);
  void wake_touched(const BrushContact& contact);
  void wake_by_gravity(const CanvasState& state, const StepInput& in);
  void list_awake();
  void list_runs();
  void list_strips();

  int width_, height_;
  float dx_m_, dy_m_;
  int tile_width_, tile_height_, columns_, rows_;
  std::vector<std::uint8_t> awake_;
  std::vector<std::uint8_t> disturbed_;  // touched, or with moving paint at the start of the step
  std::vector<std::uint8_t> moving_;     // with moving paint at the start of the step
  float travel_cells_ = 0;
  CellBox touched_;
  bool moves_ = false;
  std::vector<int> list_;
  std::vector<Run> runs_;
  std::vector<CellBox> strips_;
};

}  // namespace pentimento::conservative
