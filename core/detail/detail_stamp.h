#pragma once
// The guide's stamps on the detail canvas: the same plan, the same code per cell, with the tip and
// the paper at the fine cells' own resolution.

#include <cstdint>
#include <span>
#include <vector>

#include "core/brush/stamp_plan.h"
#include "core/detail/block_layers.h"
#include "core/detail/detail_canvas.h"
#include "core/detail/swept_tip.h"
#include "core/threads.h"

namespace pentimento {

class DetailStamp {
 public:
  /// All outlive it; `amount` as in LayerRow.
  DetailStamp(DetailCanvas& canvas, std::span<const float> amount, const Threads& threads);

  /// Lifts, as the guide just did, and remembers what its layers are before it lays.
  void lift(const StampPlan& plan, const CanvasState& guide);
  /// Opens layers in blocks where the guide did, as far as the tip touches, lays and mixes; the
  /// guide has done so.
  void lay(const StampPlan& plan, const CanvasState& guide);
  /// Cells of the guide under the last stamp.
  GuideBox box() const;

  /// Of a row of a part, counted from its first cell.
  struct Cells {
    int begin = 0, end = 0;
  };

 private:
  /// The stamp's part of one tile.
  struct Part {
    int tile = 0;
    bool usable = true;                             // there was memory for it
    int x0 = 0, x1 = 0, y0 = 0, y1 = 0;             // fine cells of the canvas
    std::vector<int> channels;                      // of the tile
    std::vector<float> amount;                      // of those
    std::vector<float*> planes;                     // [layer * channels.size() + i]
    std::vector<float> value, share, touch, grasp;  // per cell; 0 beside `touched`
    std::vector<Cells> touched;                     // per row
    std::vector<LayerOpening> opening;              // per block under the part
    std::vector<std::int8_t> target;                // -1: opens
    int width() const { return x1 - x0; }
    std::size_t line(int y) const {
      return static_cast<std::size_t>(y - y0) * static_cast<std::size_t>(width());
    }
    const Cells& touched_in(int y) const { return touched[static_cast<std::size_t>(y - y0)]; }
  };
  template <typename Body>
  void for_parts(const Body& body);
  void find_parts(const StampPlan& plan);
  void find_planes(Part& part);
  LayerRow row_of(const Part& part, int y, int begin) const;
  void measure(const StampPlan& plan, Part& part);
  void lift_part(const StampPlan& plan, Part& part);
  void note_layers(const StampPlan& plan, const CanvasState& guide, Part& part);
  void open_part(const StampPlan& plan, const CanvasState& guide, Part& part);
  void lay_part(const StampPlan& plan, Part& part);

  DetailCanvas& canvas_;
  CanvasGeometry fine_;
  std::vector<float> amount_;
  const Threads& threads_;
  std::vector<Part> parts_;  // the first `used_` are the stamp's, the others keep their buffers
  std::size_t used_ = 0;
  CellBox box_;
  SweptTip tip_;
};

}  // namespace pentimento
