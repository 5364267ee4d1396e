#pragma once
// The transfer at one stamp: paint goes from the canvas to the brush and from the brush to the
// canvas (R21-R28), and the fluid learns where the brush was. Order: pick up, refill, deposit, mix,
// contact. The transfer works only on the cells under the tip and allocates nothing once its
// scratch has grown to the largest stamp. Not thread-safe. The rows of a large stamp run on
// `threads`, and sums are added in the order of rows; beside a small stamp another thread draws the
// tip of the next.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/threads.h"
#include "core/brush/brush_settings.h"
#include "core/brush/collect_paint.h"
#include "core/brush/drawn_tip.h"
#include "core/brush/reservoir.h"
#include "core/brush/stamp.h"
#include "core/brush/stamp_cells.h"
#include "core/brush/stamp_listener.h"
#include "core/brush/stamp_plan.h"
#include "core/brush/tip.h"
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

  /// Does one stamp on the canvas and on `reservoir`. `next`: the stamp that will probably come
  /// next, with the same hand and reservoir; nullptr: unknown. It changes no result.
  void apply(const Stamp& stamp, const Stamp* next, const BrushInHand& hand, const Model& model,
             Reservoir& reservoir);
  /// Call it before another brush is taken.
  void forget_tip();
  /// How many stamps found their tip drawn.
  std::int64_t drawn_ahead() const { return drawn_ahead_; }

 private:
  struct RowSums {
    double value = 0;         // of the tip
    double value_height = 0;  // times h
    double value_base = 0;    // times b
    double value_base2 = 0;   // times b^2
    double share = 0;         // after levelling
    double ahead = 0;         // value where the stroke has not been yet
    double ahead_dry = 0;     // ... and the canvas is dry
    double returned = 0;      // volume of the surplus that was deposited
  };

  /// What R24 leaves of a brush.
  struct BrushDryness {
    float density_frac = 1, dry_ahead_frac = 1;
  };

  using Pass = void (Transfer::*)(const StampPlan&, int begin, int end);
  /// Runs a pass over [0, count), in parts of `part` where the stamp is worth threads.
  void for_parts(const StampPlan& plan, int count, int part, Pass pass);
  void for_bands(const StampPlan& plan, Pass pass);
  // Over rows of the box:
  void measure_rows(const StampPlan& plan, int begin, int end);
  void find_passed(const StampPlan& plan, int y);
  void touch_rows(const StampPlan& plan, int begin, int end);
  // Over bands of its rows:
  void pick_up_bands(const StampPlan& plan, int begin, int end);
  void put_back_bands(const StampPlan& plan, int begin, int end);
  void deposit_bands(const StampPlan& plan, int begin, int end);
  void weigh_row(const StampPlan& plan, int y);
  void sample_row(const StampPlan& plan, int y);
  void dilute_push(const StampPlan& plan, int y);
  void find_places(const StampPlan& plan);
  float* paint_at(const StampPlan& plan, std::size_t cell);
  std::span<double> sums_of(int band);
  const DrawnTip& tip() const { return tips_[now_]; }
  void prepare(const FootprintBox& box);
  BrushDryness find_dryness(const StampPlan& plan, const BrushInHand& hand,
                            const Reservoir& reservoir) const;
  void exchange_and_draw(StampPlan& plan, const StampPlan& after, const BrushInHand& hand,
                         const BrushDryness& dryness, Reservoir& reservoir);
  void exchange(StampPlan& plan, const BrushInHand& hand, const BrushDryness& dryness,
                Reservoir& reservoir);
  void find_heights(const BrushInHand& hand, StampPlan& plan) const;
  void place(const Stamp& stamp, const BrushInHand& hand, float density_frac,
             StampPlan& plan) const;
  void set_rates(const Stamp& stamp, const BrushInHand& hand, const Model& model,
                 const Reservoir& reservoir, StampPlan& plan) const;
  bool find_share_scale(StampPlan& plan) const;
  void pick_up_and_refill(const StampPlan& plan, const BrushInHand& hand, Reservoir& reservoir);
  void return_surplus(const StampPlan& plan, const BrushInHand& hand, const BrushDryness& dryness,
                      Reservoir& reservoir);
  void add_to(PaintFlow& flow);

  CanvasState& state_;
  BrushContact& contact_;
  PaintAccount& account_;
  StampCells cells_;
  std::size_t parts_;  // height and channels
  const Threads& threads_;
  StampListener* listener_ = nullptr;

  // The tip of this stamp, and that of the next; which is which changes when the next is drawn.
  std::array<DrawnTip, 2> tips_;
  std::size_t now_ = 0;
  bool is_drawn_ = false;  // the tip of this stamp was drawn beside the one before
  std::int64_t drawn_ahead_ = 0;

  // Scratch of one stamp. Of the cells of its box:
  std::vector<float> passed_m_;  // passed_height_m() of touched cells
  // Of its rows:
  std::vector<RowSums> row_;
  std::vector<TouchedCells> touched_;
  // Of the touched cells of all rows:
  std::vector<float> share_;           // value of the tip after contact levelling
  std::vector<float> hold_;            // how hard the bristles hold, [0,2]
  std::vector<float> pick_up_weight_;  // of a blade: what pick_up_row() takes
  std::vector<float> old_frac_;        // of the paint, the part that lay there before the deposit
  std::vector<float> paint_;           // picked up, then deposited: `stride` floats per cell
  // Of bands of rows:
  std::vector<double> band_paint_;  // `parts_` each
  std::vector<double> paint_sum_;
};

}  // namespace pentimento
