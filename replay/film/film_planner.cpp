#include "replay/film/film_planner.h"

#include <algorithm>
#include <cmath>

namespace pentimento {

namespace {
constexpr double kUsualLength_s = 20;    // of a film of a long painting
constexpr double kUsualIdleCut_s = 0.5;  // of painting time: long enough to see that a stroke ended

bool changes_at_once(const log::Action& action) {
  return std::holds_alternative<log::Dry>(action) || std::holds_alternative<log::Clear>(action) ||
         std::holds_alternative<log::Load>(action) || std::holds_alternative<log::Undo>(action) ||
         std::holds_alternative<log::Redo>(action);
}
}  // namespace

void FilmPlanner::busy_until(std::int64_t step) {
  if (busy_.empty() || busy_.back().to < step_) {
    busy_.push_back({step_, step});
  } else {
    busy_.back().to = std::max(busy_.back().to, step);
  }
}

void FilmPlanner::add(const log::Event& event) {
  if (!down_.empty()) {
    const std::int64_t now = stepped_ ? step_ : clock_.step_of(event.time_us);
    busy_until(now);
  }
  if (stepped_) {
    if (std::holds_alternative<log::Step>(event.action)) ++step_;
  } else {
    step_ = clock_.step_of(event.time_us);
  }
  if (changes_at_once(event.action)) busy_until(step_ + 1);
  const auto* touch = std::get_if<log::Touch>(&event.action);
  if (touch == nullptr) return;
  samples_.push_back(step_);
  busy_until(step_ + 1);
  if (touch->phase == log::TouchPhase::kUp || touch->phase == log::TouchPhase::kCancel) {
    down_.erase(touch->id);
  } else {
    down_.insert(touch->id);
  }
}

/// The axis of time, in steps, with its pauses cut.
std::vector<FilmPlanner::FilmKnot> FilmPlanner::knots(const FilmChoice& choice,
                                                      std::int64_t steps) const {
  const bool cuts = choice.idle_cut_s || choice.along == FilmAxis::kPainting;
  const double cut =
      cuts ? choice.idle_cut_s.value_or(kUsualIdleCut_s) / static_cast<double>(clock_.dt_s())
           : static_cast<double>(steps);
  std::vector<FilmKnot> axis{{0, 0}};
  const auto go_to = [&](std::int64_t step, double most) {
    const double by = static_cast<double>(step) - axis.back().step;
    if (by > 0) axis.push_back({axis.back().at + std::min(by, most), static_cast<double>(step)});
  };
  for (const Busy& busy : busy_) {
    go_to(std::min(busy.from, steps), cut);
    go_to(std::min(busy.to, steps), static_cast<double>(steps));
  }
  go_to(steps, cut);
  return axis;
}

int FilmPlanner::frame_count(const FilmChoice& choice, double axis_steps) const {
  if (choice.frames) return *choice.frames;
  const double length_s = choice.length_s.value_or(
      std::min(kUsualLength_s, axis_steps * static_cast<double>(clock_.dt_s())));
  return std::max(1, static_cast<int>(std::lround(length_s * choice.frames_per_second)));
}

std::vector<std::int64_t> FilmPlanner::frames(const FilmChoice& choice, std::int64_t steps) const {
  const std::vector<FilmKnot> axis = knots(choice, steps);
  const int count = frame_count(choice, axis.back().at);
  std::vector<std::int64_t> shown;
  std::size_t knot = 0;
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i + 1) / count;
    if (choice.along == FilmAxis::kEvents && !samples_.empty()) {
      // The sample that completes the share, and what is done at the end of its step.
      const auto last =
          static_cast<std::size_t>(std::ceil(share * static_cast<double>(samples_.size())));
      shown.push_back(std::min(steps, samples_[std::max<std::size_t>(last, 1) - 1] + 1));
      continue;
    }
    const double at = share * axis.back().at;
    while (knot + 1 < axis.size() && axis[knot + 1].at < at) ++knot;
    const FilmKnot& a = axis[knot];
    const FilmKnot& b = axis[std::min(knot + 1, axis.size() - 1)];
    const double part = b.at > a.at ? std::min(1.0, (at - a.at) / (b.at - a.at)) : 1;
    shown.push_back(std::llround(a.step + part * (b.step - a.step)));
  }
  shown.back() = steps;
  return shown;
}

}  // namespace pentimento
