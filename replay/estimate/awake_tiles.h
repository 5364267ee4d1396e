#pragma once
// Where and how long paint would move, tile by tile of the guide: what the simulation's time goes
// into. For estimates; nothing is simulated.

#include <cstdint>
#include <vector>

#include "core/brush/brush_settings.h"
#include "core/canvas/canvas_state.h"

namespace pentimento {

/// How much of the canvas moves, summed over steps.
struct MovingPaint {
  double cell_steps = 0;     // cells of the guide in tiles that move
  double channel_steps = 0;  // each of them once for every channel that its tile has wet
};

/// Whether the brush lays paint that runs on a tilted canvas.
bool deposits_thin_paint(const BrushSettings& brush);
/// Steps that paint moves after the last touch of such a brush: thin paint longer.
std::int64_t settling_steps(const BrushSettings& brush);

/// Tiles of 32 x 32 cells, about those in which the scheme sleeps and wakes.
class AwakeTiles {
 public:
  explicit AwakeTiles(const CanvasGeometry& grid);

  /// Paint of the channels in `mask` is touched at step `step`.
  struct PaintedCells {
    std::uint32_t mask;
    std::int64_t step, settling_steps;
  };
  /// In the tile of the guide's cell (x, y).
  void touch(int x, int y, const PaintedCells& touch);
  /// In all tiles under the cells [x, x + width) x [y, y + height).
  void touch(int x, int y, int width, int height, const PaintedCells& touch);
  /// Gravity along the canvas from step `step` on: on a tilted canvas all that is wet moves.
  void tilt(double lateral_m_s2, std::int64_t step);
  /// Nothing is wet any more.
  void clear();
  /// The session ends at step `step`.
  void finish(std::int64_t step);

  const MovingPaint& awake() const { return awake_; }              // after touches
  double tilted_cell_steps() const { return tilted_cell_steps_; }  // while the canvas is tilted
  /// Share of the canvas, cut into sleep tiles of `width` x `height` cells, whose tiles have come
  /// within 32 cells of paint that was ever touched.
  double reached_share(int width, int height) const;
  /// The same of the paint that was touched, or moved after it, within a look at tiles that rest
  /// (RestingTiles) and the one before, when that was most. Known after finish().
  double most_used_share(int width, int height) const;

 private:
  struct Tile {
    std::int64_t touched = -1;  // the step of the last touch; -1: dry
    std::int64_t settling_steps = 0;
    std::uint32_t mask = 0;  // channels that it has wet
  };
  void add(const Tile& tile, std::int64_t steps);
  void look();
  double share_near(const std::vector<std::uint8_t>& tiles, int width, int height) const;

  int width_, height_;  // cells
  int columns_;
  std::vector<Tile> tiles_;
  std::vector<std::uint8_t> ever_;  // touched, also if it dried since
  std::vector<std::uint8_t> used_;  // lately, when these were most
  std::int64_t most_used_ = 0;
  std::int64_t last_touch_ = 0, next_look_ = 0;  // steps
  std::int64_t wet_tiles_ = 0;
  std::int64_t tilted_since_ = -1;  // step; -1: lies flat
  MovingPaint awake_;
  double tilted_cell_steps_ = 0;
};

}  // namespace pentimento
