#pragma once
// The plan of one stamp: all that is the same for every cell, and what happens in a cell as pure
// functions of the plan. The functions do not depend on the size of a cell, so a second canvas of
// finer cells does the same stamp with the same code: it asks for the tip at its own resolution
// (stamp_tip_level) and computes boxes and rows from the pose with its own geometry.

#include <algorithm>
#include <cstdint>

#include "core/brush/reservoir.h"
#include "core/brush/stamp.h"
#include "core/brush/tip.h"
#include "core/brush/tip_pose.h"
#include "core/canvas/canvas_state.h"
#include "core/layers/deposit.h"
#include "core/layers/mix_layers.h"
#include "core/layers/pick_up.h"

namespace pentimento {

/// Plain values and pointers, valid while the stamp is done.
struct StampPlan {
  Stamp stamp;
  const Tip* tip = nullptr;
  const PaintLoad* load = nullptr;
  const Reservoir* reservoir = nullptr;
  TipPose pose;
  TipExtent extent;
  FootprintBox box;  // of the canvas that the stamp was planned on
  int stride = 4;    // floats of paint per cell: height, channels, padding
  TipState state;    // of the tip
  float mean = 1;    // mean value of the tip as it is pressed, > 0
  float dry_m = 0;
  std::uint32_t stroke_id = 0;
  PickUp pick_up;
  MixLayers mix;
  Deposit deposit;
  float film_rate = 0;    // share of the reservoir's volume deposited where the tip's value is 1
  float return_frac = 0;  // share of the surplus that goes back where the tip touches fully
  float level_per_m = 0;  // contact levelling: the deposit falls by this per metre above the mean
  double mean_height_m = 0;  // of the surface under the tip
  float mean_base_m = 0;     // ... and of the ground below the wet paint
  float catch_per_m = 0;     // dry brush: how sharply the deposit ends below the ground it reaches,
  float catch_offset = 1;    // and what it is on ground of mean height; 0 per metre: it reaches all
  float pickup_frac = 0;     // share that bristles pick up; as in `pick_up`, unless it scrapes
  float scrape_frac = 0;     // a blade takes this share of the wet paint above ...
  float scrape_height_m = 0;  // ... this height
  float share_scale = 1;      // keeps the total, which levelling only redistributes
  float push_m = 0;
};

/// The tip as cells of the size `cell_m` (the root of their area) see it.
inline TipLevel stamp_tip_level(const StampPlan& plan, float cell_m) {
  return plan.tip->level_for(cell_m / plan.pose.diameter_m, plan.state);
}

/// The hold of the bristles, in [0,2], where the tip's value is `value`. `grip`: Tip::grip_table()
/// there.
inline float stamp_hold(const StampPlan& plan, float value, float grip) {
  return std::min(1.0f, value / plan.mean) * grip;
}

struct CellHeight {
  float depth_m = 0;    // of the wet paint
  float surface_m = 0;  // height of its surface, b + d
};

/// The weight that pick_up_row() takes, with plan.pick_up, where the bristles hold with `hold`. For
/// bristles it is `hold`; for a blade it follows from what stands above the blade's edge. `takes`:
/// BladeEnds::takes at the cell.
inline float stamp_pick_up_weight(const StampPlan& plan, float hold, float takes,
                                  const CellHeight& cell) {
  if (!(plan.scrape_frac > 0)) return hold;
  const float above = std::clamp(cell.surface_m - plan.scrape_height_m, 0.0f, cell.depth_m);
  const float scraped = cell.depth_m > 0 ? plan.scrape_frac * (above / cell.depth_m) : 0.0f;
  return std::max(plan.pickup_frac * hold, std::min(hold, 1.0f) * scraped * takes);
}

/// Contact levelling (A22): the factor on the deposit at a height, in [0,2]; less on bumps and more
/// in hollows. A blade fills up to its edge: the factor falls over the last 0.15 mm to the veil
/// that a blade smears over what stands higher; not where its ends are `open` (BladeEnds).
inline float stamp_level_factor(const StampPlan& plan, float open, float height_m) {
  const float above = height_m - static_cast<float>(plan.mean_height_m);
  const float level = std::clamp(1 - plan.level_per_m * above, 0.0f, 2.0f);
  if (!(plan.scrape_frac > 0)) return level;
  constexpr float kRoom_m = 1.5e-4f;
  constexpr float kVeil = 0.04f;  // colour below still breaks through, and no cell is left bare
  const float room = std::clamp((plan.scrape_height_m - height_m) / kRoom_m, kVeil, 1.0f);
  return room + open * (level - room);
}

/// Dry brush: 1 where the bristles reach down to ground of height `base_m`, 0 where they pass over
/// it, smooth between. Wet paint on it does not count: it carries no bristles (ADR 27).
inline float stamp_caught(const StampPlan& plan, float base_m) {
  if (plan.catch_per_m == 0) return 1;
  const float above = base_m - plan.mean_base_m;
  const float t = std::clamp(plan.catch_offset + plan.catch_per_m * above, 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

/// The tip's value in a cell, times both factors above, without `share_scale`.
inline float stamp_levelled(const StampPlan& plan, float value, float open, float base_m,
                            float depth_m) {
  return value * stamp_level_factor(plan, open, base_m + depth_m) * stamp_caught(plan, base_m);
}

/// What a cell gets of the paint that the reservoir holds over it.
struct DepositedVolume {
  float part = 0;      // share of the sampled paint that is deposited
  float returned = 0;  // of the surplus
};
/// A cell gets a film of paint, and a part of the surplus. `volume`: PaintLoad::volume_of() of the
/// reservoir's sample at the cell, m. `value`: the tip's value. `share`: stamp_levelled() times
/// `share_scale`, > 0.
inline DepositedVolume stamp_deposited(const StampPlan& plan, float volume, float value,
                                       float share) {
  const float load_m = plan.load->volume_m;
  const float surplus = std::max(0.0f, volume - load_m);
  const float back = plan.return_frac * share * surplus / std::max(value, plan.mean);
  const float film = plan.film_rate * share * std::min(volume, load_m);
  return {volume > 0 ? (film + back) / volume : 0.0f, back};
}

/// The push at (u, v) in tip coordinates, in metres along the stroke's direction: alpha ds e(r). e
/// = 1.5 (1 - r^2)^2 falls from 1.5 in the middle of the tip to 0 at its edge.
inline float stamp_push_m(const StampPlan& plan, float u, float v) {
  const float x = u * (2 / plan.extent.u), y = v * (2 / plan.extent.v);
  const float inside = 1 - (x * x + y * y);
  return inside > 0 ? 1.5f * inside * inside * plan.push_m : 0.0f;
}

}  // namespace pentimento
