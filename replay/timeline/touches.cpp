#include "replay/timeline/touches.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace pentimento {

namespace {
constexpr double kMicroseconds = 1e6;
constexpr double kRadians = 3.14159265358979323846 / 180;

float radians(const std::optional<double>& degrees) {
  return static_cast<float>(degrees.value_or(0) * kRadians);
}

TouchSample sample_of(const PlacedTouch& at, float diameter_m) {
  const log::Touch& touch = at.touch;
  TouchSample sample;
  sample.x_m = touch.x_m;
  sample.y_m = touch.y_m;
  sample.time_s = static_cast<double>(at.moment.time_us) / kMicroseconds;
  sample.diameter_m = diameter_m;
  sample.pressure = static_cast<float>(touch.pressure.value_or(-1));
  sample.tilt_x_rad = radians(touch.tilt_x_deg);
  sample.tilt_y_rad = radians(touch.tilt_y_deg);
  sample.twist_rad = radians(touch.twist_deg);
  return sample;
}

std::int64_t microseconds(double time_s) {
  return static_cast<std::int64_t>(time_s * kMicroseconds + 0.5);
}
}  // namespace

Touches::Down* Touches::find(std::int64_t id) {
  const auto found =
      std::find_if(down_.begin(), down_.end(), [id](const Down& d) { return d.id == id; });
  return found == down_.end() ? nullptr : &*found;
}

int Touches::free_slot() const {
  int slot = 0;
  const auto taken = [&](const Down& d) { return d.slot == slot; };
  while (std::any_of(down_.begin(), down_.end(), taken)) ++slot;
  return slot;
}

void Touches::down(const PlacedTouch& at, const BrushSize& brush, std::uint32_t stroke_id,
                   CueQueue& out) {
  const int slot = free_slot();
  const TouchSample sample = sample_of(at, brush.diameter_m);
  Down down{at.touch.id,
            slot,
            StrokePath(brush.spacing_frac, canvas_.width_m, canvas_.height_m),
            at.moment,
            at.moment,
            at.moment,
            at.line,
            sample.pressure};
  down.path.begin(sample);
  out.push({{at.moment.time_us, at.line, 0, StrokeBegin{slot, stroke_id}}, at.moment.place, 0});
  down_.push_back(std::move(down));
}

void Touches::move(const PlacedTouch& at, const BrushSize& brush, CueQueue& out) {
  Down* down = find(at.touch.id);
  if (down == nullptr) return;
  TouchSample sample = sample_of(at, brush.diameter_m);
  // Devices report no pressure, or zero, for the moment of lifting: the tip keeps its last one.
  if (at.touch.phase == log::TouchPhase::kUp) sample.pressure = down->pressure;
  down->path.set_spacing(brush.spacing_frac);
  down->path.add(sample, stamps_);
  emit(*down, out);
  down->before = down->last;
  down->last = at.moment;
  down->line = at.line;
  down->pressure = sample.pressure;
}

void Touches::up(const PlacedTouch& at, const BrushSize& brush, CueQueue& out) {
  Down* down = find(at.touch.id);
  if (down == nullptr) return;
  move(at, brush, out);
  finish(*down, out);
  down_.erase(down_.begin() + (down - down_.data()));
}

void Touches::end(CueQueue& out) {
  for (Down& down : down_) finish(down, out);
  down_.clear();
}

void Touches::finish(Down& down, CueQueue& out) {
  down.path.finish(stamps_);
  emit(down, out);
  out.push({{down.last.time_us, down.line, 0, StrokeEnd{down.slot}}, down.last.place, 0});
}

/// Moves the stamps that are final into the queue. A stamp takes the place of the sample that it
/// follows in time, so that it comes after what the log says before that sample.
void Touches::emit(const Down& down, CueQueue& out) {
  for (const Stamp& stamp : stamps_) {
    const std::int64_t time_us = microseconds(stamp.time_s);
    const std::int64_t place = time_us >= down.last.time_us ? down.last.place : down.before.place;
    out.push({{time_us, down.line, 0, StrokeStamp{down.slot, stamp}}, place, 0});
  }
  stamps_.clear();
}

std::optional<LogMoment> Touches::final_until() const {
  std::optional<LogMoment> first;
  for (const Down& down : down_) {
    const LogMoment moment{microseconds(down.path.final_until_s()), down.before.place};
    if (!first || std::tie(moment.time_us, moment.place) < std::tie(first->time_us, first->place)) {
      first = moment;
    }
  }
  return first;
}

}  // namespace pentimento
