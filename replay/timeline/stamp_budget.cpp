#include "replay/timeline/stamp_budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pentimento {

namespace {
// Every sample takes a little time of its own, and so does a far one, whose way is walked in up to
// 4096 steps: as much as some tens of stamps.
constexpr double kOfASample = 1;
constexpr double kOfAFarSample = 50;

/// The share [from, to] of the way a -> a + by that lies in [low, high].
void clip(double a, double by, double low, double high, double& from, double& to) {
  if (by == 0) {
    if (a < low || a > high) to = from - 1;
    return;
  }
  from = std::max(from, std::min((low - a) / by, (high - a) / by));
  to = std::min(to, std::max((low - a) / by, (high - a) / by));
}
}  // namespace

StampBudget::StampBudget(const log::Header& header, const BrushTable& brushes,
                         const log::Limits& limits)
    : width_m_(header.canvas_width_m),
      height_m_(header.canvas_height_m),
      limits_(limits),
      brush_(brushes) {}

double StampBudget::stamps_between(const Place& a, const Place& b) const {
  const double dx = b.x_m - a.x_m, dy = b.y_m - a.y_m;
  const double length_m = std::sqrt(dx * dx + dy * dy);
  const double step_m = brush_.spacing_frac() * std::min(a.diameter_m, b.diameter_m);
  const double reach_m = std::max(a.diameter_m, b.diameter_m);
  double from = 0, to = 1;
  clip(a.x_m, dx, -reach_m, width_m_ + reach_m, from, to);
  clip(a.y_m, dy, -reach_m, height_m_ + reach_m, from, to);
  const double near_m = std::max(0.0, to - from) * length_m;
  const double far_steps = (length_m - near_m) / step_m;
  return near_m / step_m + std::min(far_steps, kOfAFarSample) + kOfASample;
}

Result<void> StampBudget::add(const log::Event& event) {
  brush_.follow(event.action);
  const auto* touch = std::get_if<log::Touch>(&event.action);
  if (touch == nullptr) return {};
  const Place place{touch->x_m, touch->y_m, static_cast<double>(brush_.diameter_m())};
  const auto [found, is_new] = down_.try_emplace(touch->id, place);
  const double asked = is_new ? kOfASample : stamps_between(found->second, place);
  found->second = place;
  if (touch->phase == log::TouchPhase::kUp || touch->phase == log::TouchPhase::kCancel)
    down_.erase(found);
  stamps_ += asked;
  if (asked > static_cast<double>(limits_.max_move_stamps)) {
    return Error{
        ErrorCode::kLimit,
        fmt::format("a way of {:.0f} stamps from the sample before, more than {}{}", asked,
                    limits_.max_move_stamps, log::limit_note(&log::Limits::max_move_stamps))};
  }
  if (stamps_ > static_cast<double>(limits_.max_stamps)) {
    return Error{ErrorCode::kLimit, fmt::format("more than {} stamps{}", limits_.max_stamps,
                                                log::limit_note(&log::Limits::max_stamps))};
  }
  return {};
}

}  // namespace pentimento
