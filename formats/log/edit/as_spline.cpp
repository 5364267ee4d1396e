#include "formats/log/edit/as_spline.h"

namespace pentimento::log {

void AsSpline::take(const Event& event) {
  const auto* touch = std::get_if<Touch>(&event.action);
  if (touch == nullptr && open_.empty()) return hand_on(event);
  held_.push_back(event);
  dropped_.push_back(0);
  if (touch == nullptr) return;
  open_[touch->id].push_back(held_.size() - 1);
  if (touch->phase != TouchPhase::kUp && touch->phase != TouchPhase::kCancel) return;
  end_stroke(open_[touch->id]);
  open_.erase(touch->id);
  if (open_.empty()) finish();
}

/// Decides which of a stroke's samples stay.
void AsSpline::end_stroke(std::vector<std::size_t>& samples) {
  std::vector<TimedTouch> stroke;
  for (const std::size_t i : samples)
    stroke.push_back({held_[i].time_us, std::get<Touch>(held_[i].action), false});
  for (std::size_t s = 0; s + 1 < samples.size(); ++s)
    for (std::size_t i = samples[s] + 1; i < samples[s + 1]; ++i)
      if (!std::holds_alternative<Touch>(held_[i].action))
        stroke[s].keep = stroke[s + 1].keep = true;
  keep_for_spline(stroke, tolerance_);
  for (std::size_t s = 0; s < samples.size(); ++s) dropped_[samples[s]] = !stroke[s].keep;
}

void AsSpline::finish() {
  for (std::size_t i = 0; i < held_.size(); ++i)
    if (!dropped_[i]) hand_on(held_[i]);
  held_.clear();
  dropped_.clear();
}

}  // namespace pentimento::log
