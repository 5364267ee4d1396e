#include "replay/timeline/timeline.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "core/base/interruption.h"
#include "replay/timeline/brush_track.h"
#include "replay/timeline/cue_queue.h"
#include "replay/timeline/touches.h"

namespace pentimento {

struct Timeline::Impl {
  Impl(log::Reader& log, const TimelineInput& in)
      : reader(log),
        input(in),
        clock(log.header().steps_per_second),
        brush(in.brushes),
        touches({log.header().canvas_width_m, log.header().canvas_height_m}),
        stroke_id(in.first_stroke_id) {}

  Result<void> read_one();
  void take(const log::Event& event);
  void take_touch(const log::Touch& touch, const log::Event& event);
  bool front_is_final() const;
  std::optional<Cue> release();

  log::Reader& reader;
  const TimelineInput input;
  const StepClock clock;
  BrushTrack brush;
  Touches touches;
  CueQueue queue;
  std::int64_t place = 0;  // events read
  std::int64_t unit = 0;   // units of undo begun
  std::uint32_t stroke_id;
  std::int64_t step = 0;  // of the last cue: never goes back
  bool at_end = false;
};

Timeline::Timeline(log::Reader& reader, const TimelineInput& input)
    : impl_(std::make_unique<Impl>(reader, input)) {}
Timeline::~Timeline() = default;

Result<std::optional<Cue>> Timeline::next(const std::atomic<bool>* cancelled) {
  while (true) {
    while (!impl_->front_is_final()) {
      if (impl_->at_end) return std::optional<Cue>{};
      if (Result<void> go = unless_interrupted(cancelled); !go) return go.error();
      if (Result<void> read = impl_->read_one(); !read) return read.error();
    }
    if (std::optional<Cue> cue = impl_->release()) return cue;
  }
}

const Cue* Timeline::peek() const {
  return impl_->queue.empty() ? nullptr : &impl_->queue.front().cue;
}

Result<void> Timeline::Impl::read_one() {
  Result<std::optional<log::Event>> event = reader.next();
  if (!event) return event.error();
  if (event->has_value()) {
    take(**event);
  } else {
    at_end = true;
    touches.end(queue);
  }
  return {};
}

void Timeline::Impl::take(const log::Event& event) {
  ++place;
  brush.follow(event.action);
  if (const auto* touch = std::get_if<log::Touch>(&event.action)) return take_touch(*touch, event);
  if (std::holds_alternative<log::Undo>(event.action) ||
      std::holds_alternative<log::Redo>(event.action)) {
    return;
  }
  if (UndoTable::begins_unit(event.action) && !input.undo.played(unit++)) return;
  queue.push({{event.time_us, event.line, 0, event.action}, place, 0});
}

void Timeline::Impl::take_touch(const log::Touch& touch, const log::Event& event) {
  const PlacedTouch at{touch, {event.time_us, place}, event.line};
  const BrushSize size{brush.diameter_m(), brush.spacing_frac()};
  switch (touch.phase) {
    case log::TouchPhase::kDown:
      if (!input.undo.played(unit++)) return;
      touches.down(at, size, stroke_id++, queue);
      return;
    case log::TouchPhase::kMove:
      touches.move(at, size, queue);
      return;
    case log::TouchPhase::kUp:
    case log::TouchPhase::kCancel:
      touches.up(at, size, queue);
  }
}

/// Whether no cue that is still to come can be before the front of the queue.
bool Timeline::Impl::front_is_final() const {
  if (queue.empty()) return false;
  if (at_end || queue.size() >= kMaxPending) return true;
  const std::optional<LogMoment> final_moment = touches.final_until();
  if (!final_moment) return true;
  const PendingCue& front = queue.front();
  return std::tie(front.cue.time_us, front.place) <
         std::tie(final_moment->time_us, final_moment->place);
}

/// Takes the front cue and says in which step it acts; nothing for a `step` event, which only
/// counts.
std::optional<Cue> Timeline::Impl::release() {
  Cue cue = queue.pop().cue;
  if (const auto* action = std::get_if<log::Action>(&cue.what)) {
    if (std::holds_alternative<log::Step>(*action)) {
      ++step;
      return std::nullopt;
    }
  }
  if (!input.stepped) step = std::max(step, clock.step_of(cue.time_us));
  cue.step = step;
  return cue;
}

}  // namespace pentimento
