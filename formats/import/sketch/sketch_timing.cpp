#include "formats/import/sketch/sketch_timing.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pentimento::sketch {

namespace {
constexpr double kLift_s = 0.2;  // between two strokes without times

double length_of(const Stroke& stroke) {
  double length = 0;
  for (std::size_t i = 1; i < stroke.samples.size(); ++i)
    length += std::hypot(stroke.samples[i].x - stroke.samples[i - 1].x,
                         stroke.samples[i].y - stroke.samples[i - 1].y);
  return length;
}

double duration_s(const Stroke& stroke, const TimingOptions& options) {
  if (stroke.timed) return stroke.samples.back().time_s - stroke.samples.front().time_s;
  return length_of(stroke) / options.unit_per_s;
}

/// Strokes between two actions, by their beginnings; those without times stay where they are.
void sort_segment(std::vector<TimedItem>::iterator first, std::vector<TimedItem>::iterator last) {
  const auto begin_of = [](const TimedItem& t) {
    return std::get<Stroke>(*t.item).samples.front().time_s;
  };
  const bool timed =
      std::all_of(first, last, [](const TimedItem& t) { return std::get<Stroke>(*t.item).timed; });
  if (!timed) return;
  std::stable_sort(first, last, [&](const TimedItem& a, const TimedItem& b) {
    return begin_of(a) < begin_of(b);
  });
}

/// When a stroke may begin: no sooner than the last action, nor while a stroke is painted that
/// looks otherwise; and not much later than what was before.
class Schedule {
 public:
  explicit Schedule(const TimingOptions& options) : options_(options) {}

  void add(TimedItem& timed, const Stroke& stroke) {
    double begin = end_s_ + (any_ ? kLift_s : 0);
    if (stroke.timed) {
      begin = stroke.samples.front().time_s + shift_s_;
      if (!any_) begin = 0;
      const double latest = std::max(floor_s_, end_s_) + options_.longest_pause_s;
      cut_s_ += std::max(0.0, begin - latest);
      begin = std::clamp(begin, floor_s_, latest);
      if (last_ != nullptr && !same_settings(*last_, stroke) && begin < end_s_) {
        begin = end_s_;
        ++waiting_;
      }
      shift_s_ = begin - stroke.samples.front().time_s;
    }
    timed.begin_s = begin;
    timed.shift_s = begin - stroke.samples.front().time_s;
    timed.end_s = begin + duration_s(stroke, options_);
    end_s_ = std::max(end_s_, timed.end_s);
    floor_s_ = std::max(floor_s_, stroke.timed ? floor_s_ : timed.end_s);
    last_ = &stroke;
    any_ = true;
  }
  void add_action(TimedItem& timed) {
    timed.begin_s = timed.end_s = floor_s_ = end_s_;
    last_ = nullptr;
  }
  double cut_s() const { return cut_s_; }
  int waiting() const { return waiting_; }

 private:
  const TimingOptions& options_;
  double shift_s_ = 0, end_s_ = 0, floor_s_ = 0, cut_s_ = 0;
  int waiting_ = 0;
  const Stroke* last_ = nullptr;
  bool any_ = false;
};
}  // namespace

bool same_settings(const Stroke& a, const Stroke& b) {
  return a.brush == b.brush && a.color == b.color && a.width == b.width && a.opacity == b.opacity &&
         a.erases == b.erases && a.width_share_unpressed == b.width_share_unpressed;
}

Timetable time_items(const Sketch& sketch, const TimingOptions& options) {
  std::vector<TimedItem> out;
  for (const Item& item : sketch.items) out.push_back({&item});
  const auto is_action = [](const TimedItem& t) {
    return std::holds_alternative<SketchAction>(*t.item);
  };
  for (auto first = out.begin(); first != out.end();) {
    const auto last = std::find_if(first, out.end(), is_action);
    sort_segment(first, last);
    first = last == out.end() ? last : last + 1;
  }
  Schedule schedule(options);
  for (TimedItem& timed : out) {
    if (const auto* stroke = std::get_if<Stroke>(timed.item))
      schedule.add(timed, *stroke);
    else
      schedule.add_action(timed);
  }
  return {std::move(out), schedule.cut_s(), schedule.waiting()};
}

}  // namespace pentimento::sketch
