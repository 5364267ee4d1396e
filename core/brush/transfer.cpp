#include "core/brush/transfer.h"

#include <algorithm>
#include <cmath>

#include "core/base/scratch.h"
#include "core/brush/edge_cells.h"
#include "core/brush/stamp_shares.h"

namespace pentimento {

namespace {
// Without another reason, these were chosen by what strokes look like (docs/brushes.md shows them).

constexpr float kDryFrac = 1e-3f;       // of max_medium: thinner is dry canvas (A21)
constexpr float kWeaveReach_m = 3e-4f;  // of a linen's relief: levels beside the film's own
constexpr float kDryFilm = 0.7f;        // fluid below which bristles dry rather than thin out
constexpr float kSlowing_per_s = 120;   // at so many diameters a second, half as deep
constexpr float kSoftestReach = 0.5f;   // R23: at full pressure, of the film; the stiffer, the more
constexpr float kLevelsPerFluid = 2;    // a full brush levels wholly, one half dry no more
constexpr float kBladeRide_m = 1.5e-4f;     // half a weave: a blade rides on the bumps
constexpr float kBladeClearance_m = 2e-3f;  // the blade's edge without pressure, above that
constexpr float kMostSqueezed = 1.5f;       // of a blade's film, where there is room

// How firmly bristles stand on the canvas, 1 for a full brush of middling bristle. From 0.41 of the
// pressure on they stand as firmly as they can: real hands are light, and still cover.
constexpr float kContactUnpressed = 0.3f, kContactPerPressure = 1.7f;
constexpr float kSoftestContact = 1.25f;   // times that; soft bristle gives way into hollows...
constexpr float kStiffnessContact = 0.5f;  // ...and so much less of it the stiffest
// How deep they reach below the ground's mean height, in standard deviations of its heights under
// the tip: everywhere at a contact of 0.8; at 0.24 they touch the higher half.
constexpr float kReachPerContact = 5, kReachUnpressed = -1.2f;
constexpr float kReachesAll = 2.8f;
constexpr float kDrowned = 3;  // deviations of the ground: a film so deep is even all over
constexpr float kLeastRelief_m = 2e-5f;  // deviation of a ground that has hollows

constexpr int kRowsPerTask = 8, kBandsPerTask = 4;
// Some 0.2 ms of work. To share less gains nothing: planes and tip then lie in another core's
// cache.
constexpr int kCellsWorthThreads = 3000;

bool shares_rows(const FootprintBox& box) {
  return box.width * box.height >= kCellsWorthThreads;
}

/// 1 for a slow stroke, more for a fast one, which passes over the hollows.
float speed_factor(const Stamp& stamp) {
  const Vec2f v = stamp.velocity_m_s;
  return 1 + std::sqrt(v.x * v.x + v.y * v.y) / (kSlowing_per_s * stamp.diameter_m);
}

/// Share of the film that the brush still deposits as it dries. Below kDryFilm it falls slowly, for
/// bristles that still give paint do not give much less.
float wet_film(float density_frac) {
  if (density_frac >= kDryFilm) return density_frac;
  return kDryFilm * std::sqrt(density_frac / kDryFilm);
}

/// How well a brush levels what it lays: one that runs dry passes over the hollows.
float levelling(float density_frac) {
  return std::max(0.0f, kLevelsPerFluid * density_frac - 1);
}

float stiffness_of(const BrushInHand& hand) {
  return hand.brush.stiffness < 0 ? hand.settings.stiffness : hand.brush.stiffness;
}

/// How deep the bristles reach below the ground's mean height, in deviations of its heights.
float reach_of(const StampPlan& plan, float pressure, float stiffness) {
  const float contact =
      plan.state.density_frac * std::min(1.0f, kContactUnpressed + kContactPerPressure * pressure) *
      (kSoftestContact - kStiffnessContact * stiffness) / speed_factor(plan.stamp);
  return kReachPerContact * contact + kReachUnpressed;
}

/// Share of its film that a tip deposits where it stands still. What half a diameter of way would
/// take, a narrow tip would heap up in a print of a tenth of one.
float dabbed(const Stamp& stamp, const TipExtent& extent) {
  constexpr float kWholeFilm = 0.5f;  // of the tip's square: the print of a round tip
  const bool stands = stamp.dab.x != 0 || stamp.dab.y != 0;
  return stands ? std::min(1.0f, extent.u * extent.v / kWholeFilm) : 1.0f;
}
}  // namespace

Transfer::Transfer(CanvasState& state, BrushContact& contact, PaintAccount& account,
                   std::span<const float> amount, const Threads& threads)
    : state_(state),
      contact_(contact),
      account_(account),
      cells_(state, amount),
      parts_(1 + static_cast<std::size_t>(state.channels)),
      threads_(threads),
      tips_{DrawnTip(state.geometry), DrawnTip(state.geometry)},
      paint_sum_(parts_, 0.0) {}

void Transfer::forget_tip() {
  for (DrawnTip& tip : tips_) tip.forget();
}

void Transfer::apply(const Stamp& stamp, const Stamp* next, const BrushInHand& hand,
                     const Model& model, Reservoir& reservoir) {
  if (!(hand.tip.mean() > 0) || !(stamp.travel_m >= 0)) return;
  // Where the tip is, and how strongly it acts: all that is the same for every cell.
  StampPlan plan;
  place(stamp, hand, reservoir.density_frac, plan);
  if (plan.box.empty()) return;
  plan.reservoir = &reservoir;
  plan.stride = reservoir.stride();
  set_rates(stamp, hand, model, reservoir, plan);
  prepare(plan.box);

  // What lies under the tip; from that, how far down the bristles reach, and how dry they get.
  is_drawn_ = tip().is_of(plan);
  if (is_drawn_) ++drawn_ahead_;
  if (!is_drawn_) tips_[now_].begin(plan, hand.brush.scrapes);
  for_parts(plan, plan.box.height, kRowsPerTask, &Transfer::measure_rows);
  find_heights(hand, plan);
  const BrushDryness dryness = find_dryness(plan, hand, reservoir);

  // The rest, and beside it the tips that need the dryness alone: the listener's of this stamp, and
  // that of the next. A stamp that shares its rows has work for all threads.
  if (listener_ != nullptr) listener_->begin_stamp();
  if (threads_.count() > 1 && !shares_rows(plan.box)) {
    StampPlan after;
    if (next != nullptr) place(*next, hand, dryness.density_frac, after);
    exchange_and_draw(plan, after, hand, dryness, reservoir);
  } else {
    exchange(plan, hand, dryness, reservoir);
    if (listener_ != nullptr) listener_->draw_tip(plan);
  }
  if (listener_ != nullptr) listener_->end_stamp();
}

/// Does the exchange() on one thread, and on others draws the listener's tip and that of the stamp
/// `after`, if its box is not empty.
void Transfer::exchange_and_draw(StampPlan& plan, const StampPlan& after, const BrushInHand& hand,
                                 const BrushDryness& dryness, Reservoir& reservoir) {
  const bool draws_next = !after.box.empty();
  const auto task = [&](int i) {
    if (i == 0) exchange(plan, hand, dryness, reservoir);
    if (i == 1 && listener_ != nullptr) listener_->draw_tip(plan);
    if (i == 2) tips_[1 - now_].draw(after, hand.brush.scrapes);
  };
  if (!draws_next && listener_ == nullptr) return task(0);
  // One reference is captured, so that the function object needs no memory of its own.
  threads_.for_ranges(0, draws_next ? 3 : 2, 1, [&task](int begin, int end) {
    for (int i = begin; i < end; ++i) task(i);
  });
  if (draws_next) now_ = 1 - now_;
}

/// Paint goes from the canvas to the brush and from the brush to the canvas.
void Transfer::exchange(StampPlan& plan, const BrushInHand& hand, const BrushDryness& dryness,
                        Reservoir& reservoir) {
  // The canvas gives paint to the brush (R23), the palette refills it (R22).
  find_places(plan);
  for_bands(plan, &Transfer::pick_up_bands);
  pick_up_and_refill(plan, hand, reservoir);
  // Levelling must not change how much the stamp deposits.
  const bool deposits = find_share_scale(plan);
  if (listener_ != nullptr || !deposits) for_bands(plan, &Transfer::put_back_bands);
  if (listener_ != nullptr) listener_->before_deposit(plan, state_);
  if (!deposits) return;
  // The brush gives paint to the canvas (R25), layers mix (R28), the fluid learns of the contact
  // (R17).
  for_bands(plan, &Transfer::deposit_bands);
  for_parts(plan, plan.box.height, kRowsPerTask, &Transfer::touch_rows);
  if (listener_ != nullptr) listener_->after_deposit(plan, state_);
  // The brush loses its surplus and dries (R24).
  return_surplus(plan, hand, dryness, reservoir);
}

/// Where the stamp lies and what it is made of.
void Transfer::place(const Stamp& stamp, const BrushInHand& hand, float density_frac,
                     StampPlan& plan) const {
  plan.pose = pose_on(state_.geometry, stamp, hand.brush);
  plan.extent = hand.tip.extent();
  plan.box = box_of(plan.pose, plan.extent, state_.geometry);
  plan.stamp = stamp;
  plan.tip = &hand.tip;
  plan.load = &hand.load;
  plan.state = {hand.brush.splay_at(pressure_of(stamp)) / std::sqrt(speed_factor(stamp)),
                density_frac};
  plan.mean = hand.tip.mean(plan.state.press);
  plan.stroke_id = hand.stroke_id;
}

/// Fills in the plan how much the stamp picks up, deposits, mixes and pushes. That follows from the
/// sliders, the pressure and the distance that the stamp stands for.
void Transfer::set_rates(const Stamp& stamp, const BrushInHand& hand, const Model& model,
                         const Reservoir& reservoir, StampPlan& plan) const {
  const BrushSettings& settings = hand.settings;
  const BrushDefinition& brush = hand.brush;
  const float pressure = pressure_of(stamp);
  const double diameters = travelled_diameters(stamp, plan.pose);
  plan.dry_m = kDryFrac * model.max_medium_m;
  plan.pickup_frac = pickup_share(stamp, brush, settings, plan.pose);
  plan.pick_up.share_frac = plan.pickup_frac;
  plan.pick_up.residue = model.pigment_residue;
  if (stamp.pressure >= 0 && brush.absorb == 0)
    plan.pick_up.penetration_frac =
        std::clamp(pressure * (kSoftestReach + stiffness_of(hand)), 0.0f, 1.0f);
  plan.mix = {mixing_share(stamp, settings, plan.pose), model.pigment_residue};
  plan.deposit = {model.max_medium_m, hand.stroke_id};
  // A tip finer than the grid is drawn as wide as the grid can show, and as much thinner.
  const float unpressed = stamp.diameter_m * brush.size_at(pressure);
  const float thin = std::min(1.0f, unpressed / plan.pose.diameter_m);
  // Fewer bristles lay less, though not in proportion: each is fed by those beside it. Speed leaves
  // the amount alone.
  const float unhurried = hand.tip.mean(brush.splay_at(pressure));
  const float mean = (unhurried + hand.tip.mean()) / 2 * plan.mean / unhurried;
  plan.film_rate = brush.film * wet_film(reservoir.density_frac) * brush.flow_at(pressure) * thin *
                   static_cast<float>(diameters) / (mean * kFilmsHeld) *
                   dabbed(stamp, hand.tip.extent());
  plan.return_frac = return_share(stamp, brush, plan.pose);
  plan.level_per_m = model.contact_levelling * levelling(reservoir.density_frac) /
                     (model.film_medium_m * settings.medium_frac + kWeaveReach_m);
  plan.push_m = model.brush_push * stamp.travel_m;
  // A blade takes what stands above its edge, whatever the pressure.
  if (brush.scrapes) {
    plan.pick_up.share_frac = 1;  // stamp_pick_up_weight() says how much
    plan.pick_up.penetration_frac = -1;
    plan.scrape_frac = scraped_share(stamp, plan.pose);
  }
}

/// Fills in the plan the mean of the heights under the tip, and which of them the brush reaches:
/// where a blade's edge is, or how deep the bristles of a dry or light brush come.
void Transfer::find_heights(const BrushInHand& hand, StampPlan& plan) const {
  double value = 0, height = 0, base = 0, square = 0;
  for (int y = 0; y < plan.box.height; ++y) {
    const RowSums& sums = row_[static_cast<std::size_t>(y)];
    value += sums.value;
    height += sums.value_height;
    base += sums.value_base;
    square += sums.value_base2;
  }
  if (!(value > 0)) return;
  plan.mean_height_m = height / value;
  const double mean_base_m = base / value;
  plan.mean_base_m = static_cast<float>(mean_base_m);
  const float pressure = pressure_of(plan.stamp);
  if (plan.scrape_frac > 0) {
    plan.scrape_height_m = plan.mean_base_m + kBladeRide_m + (1 - pressure) * kBladeClearance_m +
                           hand.load.paint[0] / kFilmsHeld;
    return;
  }
  const float reach = reach_of(plan, pressure, stiffness_of(hand));
  if (reach >= kReachesAll) return;
  const double variance = square / value - mean_base_m * mean_base_m;
  const float deviation_m = static_cast<float>(std::sqrt(std::max(0.0, variance)));
  plan.catch_per_m = 1 / std::max(deviation_m, kLeastRelief_m);
  // Even ground has no hollows that bristles could pass over: ground smoother than the least
  // relief, or drowned in wet paint, which carries no bristles (ADR 27). A thin film drowns little.
  const float smooth = 1 - deviation_m / kLeastRelief_m;
  const float film = static_cast<float>((height - base) / value) * plan.catch_per_m / kDrowned;
  const float even = std::clamp(std::max(smooth, film * film), 0.0f, 1.0f);
  plan.catch_offset = reach + (kReachesAll - reach) * even;
}

/// Finds the factor that keeps levelling from changing the stamp's total. If the whole tip is on
/// the canvas, the total is that of the tip; if the border cuts the tip, it is the sum over its
/// cells. Returns false if nothing can be deposited.
bool Transfer::find_share_scale(StampPlan& plan) const {
  double value = 0, share = 0;
  for (int y = 0; y < plan.box.height; ++y) {
    value += row_[static_cast<std::size_t>(y)].value;
    share += row_[static_cast<std::size_t>(y)].share;
  }
  if (!(share > 0)) return false;
  const double whole = static_cast<double>(plan.pose.diameter_m) *
                       static_cast<double>(plan.pose.diameter_m) * static_cast<double>(plan.mean) /
                       state_.geometry.cell_area_m2();
  const bool exact = plan.box.inside && plan.state.density_frac >= kDryFilm;
  plan.share_scale = static_cast<float>((exact ? whole : value) / share);
  // Under a blade that finds no room, paint stays on it.
  if (plan.scrape_frac > 0) plan.share_scale = std::min(plan.share_scale, kMostSqueezed);
  return true;
}

void Transfer::prepare(const FootprintBox& box) {
  const std::size_t rows = static_cast<std::size_t>(box.height);
  grow(passed_m_, static_cast<std::size_t>(box.width) * rows);
  grow(row_, rows);
  grow(touched_, rows);
  contact_.touch(box.x, box.x + box.width, box.y, box.y + box.height);
}

/// Gives each touched cell its place beside the others, and cuts the rows into bands.
void Transfer::find_places(const StampPlan& plan) {
  std::size_t cells = 0;
  for (int y = 0; y < plan.box.height; ++y) {
    TouchedCells& row = touched_[static_cast<std::size_t>(y)];
    row.at = cells;
    cells += row.count();
  }
  cells_.cut(plan.box, touched_);
  grow(share_, cells);
  grow(hold_, cells);
  grow(pick_up_weight_, cells);
  grow(old_frac_, cells);
  grow(paint_, cells * static_cast<std::size_t>(plan.stride));
  grow(band_paint_, cells_.bands().size() * parts_);
}

void Transfer::for_parts(const StampPlan& plan, int count, int part, Pass pass) {
  if (!shares_rows(plan.box) || threads_.count() == 1) {
    (this->*pass)(plan, 0, count);
    return;
  }
  struct PartsOfStamp {
    Transfer* transfer;
    const StampPlan* plan;
    Pass pass;
  } work{this, &plan, pass};
  // One reference is captured, so that the function object needs no memory of its own.
  threads_.for_ranges(0, count, part, [&work](int begin, int end) {
    (work.transfer->*work.pass)(*work.plan, begin, end);
  });
}

void Transfer::for_bands(const StampPlan& plan, Pass pass) {
  for_parts(plan, static_cast<int>(cells_.bands().size()), kBandsPerTask, pass);
}

/// Draws the rows of the tip, unless they have been drawn, and measures the heights of the canvas
/// under it.
void Transfer::measure_rows(const StampPlan& plan, int begin, int end) {
  for (int y = begin; y < end; ++y) {
    if (!is_drawn_) tips_[now_].draw_row(y);
    const DrawnTipRow& drawn = tip().row(y);
    const int canvas_y = plan.box.y + y;
    const float* base = state_.base_m.row(canvas_y) + plan.box.x;
    const float* depth = state_.depth_m.row(canvas_y) + plan.box.x;
    const std::uint32_t* stroke = state_.stroke.row(canvas_y) + plan.box.x;
    RowSums sums;
    for (int x = drawn.touched.begin; x < drawn.touched.end; ++x) {
      const float s = drawn.value[x];
      if (!(s > 0)) continue;
      const double value = static_cast<double>(s);
      sums.value += value;
      const double height = static_cast<double>(base[x] + depth[x]);
      sums.value_height += value * height;
      const double ground = static_cast<double>(base[x]);
      sums.value_base += value * ground;
      sums.value_base2 += value * ground * ground;
      if (stroke[x] != plan.stroke_id) {
        sums.ahead += value;
        if (depth[x] < plan.dry_m) sums.ahead_dry += value;
      }
    }
    row_[static_cast<std::size_t>(y)] = sums;
    touched_[static_cast<std::size_t>(y)] = drawn.touched;
    find_passed(plan, y);
  }
}

/// Finds how high the surface is where the tip passes, before anything is picked up beside it.
void Transfer::find_passed(const StampPlan& plan, int y) {
  const DrawnTipRow& drawn = tip().row(y);
  float* height = passed_m_.data() + static_cast<std::ptrdiff_t>(y) * plan.box.width;
  for (int x = drawn.touched.begin; x < drawn.touched.end; ++x)
    height[x] = passed_height_m(state_, plan.box.x + x, plan.box.y + y,
                                tip().passed().at(drawn.place.v(x)));
}

float* Transfer::paint_at(const StampPlan& plan, std::size_t cell) {
  return paint_.data() + cell * static_cast<std::size_t>(plan.stride);
}

std::span<double> Transfer::sums_of(int band) {
  return {band_paint_.data() + static_cast<std::size_t>(band) * parts_, parts_};
}

/// How the bristles hold each cell of a row. Contact levelling (A22): the stamp will deposit less
/// on bumps and more in hollows.
void Transfer::weigh_row(const StampPlan& plan, int y) {
  const BristleTable& grip = plan.tip->grip_table();
  const auto row = static_cast<std::size_t>(y);
  const TouchedCells& touched = touched_[row];
  const TipRow& tip = this->tip().row(y).place;
  const float* value = this->tip().row(y).value;
  const BladeEnds& ends = this->tip().ends();
  const float* base = state_.base_m.row(plan.box.y + y) + plan.box.x;
  const float* depth = state_.depth_m.row(plan.box.y + y) + plan.box.x;
  const bool scrapes = plan.scrape_frac > 0;
  const float* passed_m = passed_m_.data() + static_cast<std::ptrdiff_t>(y) * plan.box.width;
  double share = 0;
  std::size_t at = touched.at;
  for (int x = touched.begin; x < touched.end; ++x, ++at) {
    const float v = tip.v(x), height = base[x] + depth[x];
    hold_[at] = stamp_hold(plan, value[x], grip.at(v));
    const float open = scrapes ? ends.open.at(v) : 0.0f;
    const float levelled = value[x] * stamp_level_factor(plan, open, passed_m[x]);
    share += static_cast<double>(levelled);
    share_[at] = levelled * stamp_caught(plan, base[x]);
    if (scrapes)
      pick_up_weight_[at] =
          stamp_pick_up_weight(plan, hold_[at], ends.takes.at(v), {depth[x], height});
  }
  row_[row].share = share;
}

/// The paint is picked up (R23).
void Transfer::pick_up_bands(const StampPlan& plan, int begin, int end) {
  for (int i = begin; i < end; ++i) {
    const StampBand& band = cells_.bands()[static_cast<std::size_t>(i)];
    for (int y = band.begin; y < band.end; ++y) weigh_row(plan, y);
    const std::vector<float>& weight = plan.scrape_frac > 0 ? pick_up_weight_ : hold_;
    const BandPaint canvas = cells_.gather(i);
    pick_up_row(plan.pick_up, canvas.layers, {weight.data() + band.at, band.cells},
                canvas.depth_m.data(), paint_at(plan, band.at), plan.stride, sums_of(i));
  }
}

void Transfer::put_back_bands(const StampPlan&, int begin, int end) {
  for (int i = begin; i < end; ++i) cells_.put_back(i);
}

/// The picked up paint arrives in the reservoir, and the palette's paint with it (R22).
void Transfer::pick_up_and_refill(const StampPlan& plan, const BrushInHand& hand,
                                  Reservoir& reservoir) {
  add_to(account_.picked_up);
  const bool picked_up =
      std::any_of(paint_sum_.begin(), paint_sum_.end(), [](double sum) { return sum > 0; });
  if (picked_up)
    collect_picked_up({paint_, plan.stride, touched_}, plan.pose, plan.box, state_.geometry,
                      hand.tip, reservoir);
  reservoir.refill(hand.load, hand.tip,
                   refill_share(plan.stamp, hand.brush, hand.settings, plan.pose));
}

/// What the reservoir holds over each cell of a row becomes what the cell is given: the film and
/// the surplus.
void Transfer::sample_row(const StampPlan& plan, int y) {
  const auto row = static_cast<std::size_t>(y);
  const TouchedCells& touched = touched_[row];
  const DrawnTipRow& drawn = tip().row(y);
  const float* value = drawn.value;
  float* paint = paint_at(plan, touched.at);
  plan.reservoir->sample_row(drawn.place, touched.begin, touched.end - touched.begin, paint);
  double returned = 0;
  std::size_t at = touched.at;
  for (int x = touched.begin; x < touched.end; ++x, ++at, paint += plan.stride) {
    const float share = share_[at] * plan.share_scale;
    if (!(share > 0)) {
      std::fill_n(paint, plan.stride, 0.0f);
      continue;
    }
    const float volume = plan.load->volume_of(paint);
    const DepositedVolume deposited = stamp_deposited(plan, volume, value[x], share);
    for (int k = 0; k < plan.stride; ++k) paint[k] *= deposited.part;
    returned += static_cast<double>(deposited.returned);
  }
  row_[row].returned = returned;
}

/// Deposits what the cells are given, and mixes the layers.
void Transfer::deposit_bands(const StampPlan& plan, int begin, int end) {
  for (int i = begin; i < end; ++i) {
    const StampBand& band = cells_.bands()[static_cast<std::size_t>(i)];
    for (int y = band.begin; y < band.end; ++y) sample_row(plan, y);
    const BandPaint canvas = cells_.paint(i);
    float* old = old_frac_.data() + band.at;
    std::copy(canvas.depth_m.begin(), canvas.depth_m.end(), old);
    deposit_row(plan.deposit, canvas.layers, canvas.depth_m, canvas.stroke, paint_at(plan, band.at),
                plan.stride, sums_of(i));
    for (std::size_t k = 0; k < band.cells; ++k)
      old[k] = canvas.depth_m[k] > 0 ? std::min(1.0f, old[k] / canvas.depth_m[k]) : 0.0f;
    cells_.find_held(i);
    mix_layers_row(plan.mix, canvas.layers, {hold_.data() + band.at, band.cells});
    cells_.put_back(i);
  }
}

/// How dry the brush is after the stamp (R24), if it deposits.
Transfer::BrushDryness Transfer::find_dryness(const StampPlan& plan, const BrushInHand& hand,
                                              const Reservoir& reservoir) const {
  double ahead = 0, ahead_dry = 0;
  for (int y = 0; y < plan.box.height; ++y) {
    ahead += row_[static_cast<std::size_t>(y)].ahead;
    ahead_dry += row_[static_cast<std::size_t>(y)].ahead_dry;
  }
  BrushDryness after{reservoir.density_frac, reservoir.dry_ahead_frac};
  if (ahead > 0) after.dry_ahead_frac = static_cast<float>(ahead_dry / ahead);
  after.density_frac =
      std::max(0.0f, after.density_frac - after.dry_ahead_frac * plan.stamp.travel_m /
                                              (hand.brush.capacity * plan.pose.diameter_m));
  return after;
}

/// Adds to the account, takes out of the reservoir the surplus that was deposited, and dries the
/// brush (R24).
void Transfer::return_surplus(const StampPlan& plan, const BrushInHand& hand,
                              const BrushDryness& dryness, Reservoir& reservoir) {
  add_to(account_.deposited);
  double returned = 0;
  for (int y = 0; y < plan.box.height; ++y) returned += row_[static_cast<std::size_t>(y)].returned;
  if (returned > 0) {
    const double tip_area =
        static_cast<double>(plan.pose.diameter_m) * static_cast<double>(plan.pose.diameter_m);
    const double texels = returned * state_.geometry.cell_area_m2() * kReservoirTexels / tip_area;
    const double surplus = reservoir.weighted_surplus();
    if (surplus > 0)
      reservoir.drop_surplus(hand.load, hand.tip,
                             static_cast<float>(std::min(1.0, texels / surplus)));
  }
  reservoir.dry_ahead_frac = dryness.dry_ahead_frac;
  reservoir.density_frac = dryness.density_frac;
}

/// Adds the sums of the bands, in their order: into `paint_sum_` and, as volumes, into `flow`.
void Transfer::add_to(PaintFlow& flow) {
  std::fill(paint_sum_.begin(), paint_sum_.end(), 0.0);
  for (std::size_t band = 0; band < cells_.bands().size(); ++band)
    for (std::size_t k = 0; k < parts_; ++k) paint_sum_[k] += band_paint_[band * parts_ + k];
  const double area = state_.geometry.cell_area_m2();
  flow.medium_m3 += paint_sum_[0] * area;
  for (std::size_t c = 0; c + 1 < parts_; ++c) flow.channel[c] += paint_sum_[1 + c] * area;
}

/// The push of a cell is the mean over its paint. What this stamp laid has not been pushed by those
/// before it.
void Transfer::dilute_push(const StampPlan& plan, int y) {
  const TouchedCells& touched = touched_[static_cast<std::size_t>(y)];
  const float* old_frac = old_frac_.data() + touched.at;
  float* push_x = contact_.push_x_m.row(plan.box.y + y) + plan.box.x + touched.begin;
  float* push_y = contact_.push_y_m.row(plan.box.y + y) + plan.box.x + touched.begin;
  for (std::size_t k = 0; k < touched.count(); ++k) {
    push_x[k] *= old_frac[k];
    push_y[k] *= old_frac[k];
  }
}

/// Footprint, velocity (R17) and push, also where the tip's hairs leave cells out.
void Transfer::touch_rows(const StampPlan& plan, int begin, int end) {
  const Stamp& stamp = plan.stamp;
  const int first = plan.box.x;
  for (int y = begin; y < end; ++y) {
    const DrawnTipRow& drawn = tip().row(y);
    const int canvas_y = plan.box.y + y;
    const float* value = drawn.value;
    float* touched = contact_.weight.row(canvas_y) + first;
    float* velocity_x = contact_.velocity_x_m_s.row(canvas_y) + first;
    float* velocity_y = contact_.velocity_y_m_s.row(canvas_y) + first;
    for (int x = drawn.touched.begin; x < drawn.touched.end; ++x) {
      if (!(value[x] > 0)) continue;
      touched[x] = std::max(touched[x], std::min(1.0f, value[x]));
      velocity_x[x] = stamp.velocity_m_s.x;
      velocity_y[x] = stamp.velocity_m_s.y;
    }
    dilute_push(plan, y);
    const TipRow place = drawn.place;
    float* __restrict push_x = contact_.push_x_m.row(canvas_y) + first;
    float* __restrict push_y = contact_.push_y_m.row(canvas_y) + first;
    for (int x = drawn.span.begin; x < drawn.span.end; ++x) {
      const float push = stamp_push_m(plan, place.u(x), place.v(x));
      push_x[x] += push * stamp.direction.x;
      push_y[x] += push * stamp.direction.y;
    }
  }
}

}  // namespace pentimento
