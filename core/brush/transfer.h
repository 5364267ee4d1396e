#pragma once
// The transfer at one stamp: paint goes from the canvas to the brush and from the brush to the
// canvas (R21-R28), and the fluid learns where the brush was. Order: pick up, refill, deposit, mix,
// contact. The transfer works only on the cells under the tip and allocates nothing once its
// scratch has grown to the largest stamp. Not thread-safe; the rows of a large stamp run on
// `threads`, and sums are added in the order of rows.

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/threads.h"
#include "core/brush/brush_settings.h"
#include "core/brush/collect_paint.h"
#include "core/brush/reservoir.h"
#include "core/brush/stamp.h"
#include "core/brush/stamp_listener.h"
#include "core/brush/stamp_plan.h"
#include "core/brush/tip.h"
#include "core/brush/tip_footprint.h"
#include "core/brush/tip_pose.h"
#include "core/canvas/canvas_state.h"
#include "core/canvas/paint_account.h"
#include "core/fluid/brush_contact.h"
#include "core/layers/layer_row.h"
#include "core/model/model.h"

namespace pentimento {

/// The brush as it is at this stamp.
struct BrushInHand {
  const BrushDefinition& brush;
  const Tip& tip;
  const BrushSettings& settings;
  const PaintLoad& load;
  std::uint32_t stroke_id = 0;
};

class Transfer {
 public:
  /// All references must outlive the transfer. `amount`: as in LayerRow.
  Transfer(CanvasState& state, BrushContact& contact, PaintAccount& account,
           std::span<const float> amount, const Threads& threads);

  /// `listener` is told of every stamp from now on; nullptr: nobody is. It must outlive the
  /// transfer.
  void set_listener(StampListener* listener) { listener_ = listener; }

  /// Does one stamp on the canvas and on `reservoir`.
  void apply(const Stamp& stamp, const BrushInHand& hand, const Model& model, Reservoir& reservoir);

 private:
  struct RowSums {
    double value = 0;          // of the tip
    double value_height = 0;   // times h
    double value_height2 = 0;  // times h^2
    double value_base = 0;     // times b
    double share = 0;          // after levelling
    double ahead = 0;          // value where the stroke has not been yet
    double ahead_dry = 0;      // ... and the canvas is dry
    double returned = 0;       // volume of the surplus that was deposited
  };

  /// The cells of a row that the tip touches.
  struct TouchedRun {
    int x = 0, y = 0;    // of its first cell on the canvas
    std::size_t at = 0;  // of that cell in the scratch
    std::size_t cells = 0;
  };

  TouchedRun strip_of(const StampPlan& plan, int y) const;
  float* strip_paint(const StampPlan& plan, const TouchedRun& strip);
  std::span<double> strip_sums(int y);
  void measure_rows(const StampPlan& plan, int begin, int end);
  void pick_up_rows(const StampPlan& plan, int begin, int end);
  void deposit_rows(const StampPlan& plan, int begin, int end);
  void for_rows(const StampPlan& plan, void (Transfer::*pass)(const StampPlan&, int, int));
  void prepare(const FootprintBox& box, int stride);
  void find_heights(const BrushInHand& hand, StampPlan& plan) const;
  void place(const Stamp& stamp, const BrushInHand& hand, const Reservoir& reservoir,
             StampPlan& plan) const;
  void set_rates(const Stamp& stamp, const BrushInHand& hand, const Model& model,
                 const Reservoir& reservoir, StampPlan& plan) const;
  bool find_share_scale(StampPlan& plan) const;
  void pick_up_and_refill(const StampPlan& plan, const BrushInHand& hand, Reservoir& reservoir);
  void return_surplus(const StampPlan& plan, const BrushInHand& hand, Reservoir& reservoir);
  void add_to(const StampPlan& plan, PaintFlow& flow);
  void touch_row(const StampPlan& plan, const TipRow& tip, int y, std::span<const float> weight);

  CanvasState& state_;
  BrushContact& contact_;
  PaintAccount& account_;
  LayerPlanes planes_;
  std::size_t parts_;  // height and channels
  const Threads& threads_;
  StampListener* listener_ = nullptr;

  // Scratch of one stamp, over its box.
  TipFootprint footprint_;
  std::vector<float> weight_;          // value of the tip per cell
  std::vector<float> share_;           // the same after contact levelling
  std::vector<float> hold_;            // how hard the bristles hold, [0,2] per cell
  std::vector<float> pick_up_weight_;  // of a blade: what pick_up_row() takes
  std::vector<float> paint_;           // picked up, then deposited: `stride` floats per cell
  std::vector<double> row_paint_;      // `parts_` per row
  std::vector<double> paint_sum_;
  std::vector<RowSums> row_;
  std::vector<TouchedCells> touched_;  // per row
  std::vector<TipRow> tip_row_;        // where its cells lie on the tip
};

}  // namespace pentimento
