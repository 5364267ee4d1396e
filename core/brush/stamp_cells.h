#pragma once
// The wet paint under a stamp, band by band. A narrow tip touches some ten cells of a row, and
// loops over vectors of cells need more: the cells of such rows are gathered side by side, one row
// for all kernels of core/layers, and put back afterwards. A row that is long enough stays where it
// is. What a stamp does to a cell does not depend on other cells, so the bands do not change it.

#include <cstdint>
#include <span>
#include <vector>

#include "core/brush/tip_pose.h"
#include "core/brush/touched_cells.h"
#include "core/canvas/canvas_state.h"
#include "core/layers/layer_row.h"

namespace pentimento {

/// Rows [begin, end) of the stamp's box, whose touched cells are worked on together.
struct StampBand {
  int begin = 0, end = 0;
  std::size_t at = 0;  // of its first cell among all touched cells
  std::size_t cells = 0;
};

/// The paint of a band's cells as kernels want it.
struct BandPaint {
  LayerRow layers;
  std::span<float> depth_m;
  std::uint32_t* stroke = nullptr;
};

/// The touched cells of a row.
struct CellRun {
  std::ptrdiff_t offset = 0;  // of the first in each plane of the canvas
  std::size_t at = 0, count = 0;
};

class StampCells {
 public:
  /// Both must outlive it. `amount`: as in LayerRow.
  StampCells(CanvasState& state, std::span<const float> amount);

  /// Cuts the rows of `box` into bands. `rows`: one for each, with their places; they must stay
  /// until the next cut. Allocates nothing once it has grown to the largest stamp.
  void cut(const FootprintBox& box, std::span<const TouchedCells> rows);
  std::span<const StampBand> bands() const { return bands_; }

  // Different bands may be worked on at the same time.
  /// Reads a band's paint from the canvas.
  BandPaint gather(int band);
  /// The paint of a band that was gathered.
  BandPaint paint(int band);
  /// Looks again which planes hold paint, after some was laid.
  void find_held(int band);
  /// Writes a gathered band's paint to the canvas.
  void put_back(int band);

 private:
  bool stays(const StampBand& band) const { return band.end - band.begin == 1; }
  std::span<const CellRun> runs_of(const StampBand& band) const;
  std::span<std::uint8_t> held(int band);

  CanvasState& state_;
  LayerPlanes planes_;
  std::vector<CellRun> runs_;  // per row
  std::vector<StampBand> bands_;
  std::vector<float*> cells_;   // per plane of pigment: all cells that are gathered
  std::vector<float> pigment_;  // ... one plane after the other
  std::vector<float> depth_m_;  // of the same cells
  std::vector<std::uint32_t> stroke_;
  std::vector<std::uint8_t> held_;  // per band and plane: whether it holds anything
};

}  // namespace pentimento
