#include "replay/session/log_plan.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "replay/job/step_clock.h"

namespace pentimento {

namespace {
/// The file an event names; empty if none.
std::string named_file(const log::Action& action) {
  if (const auto* load = std::get_if<log::Load>(&action)) return load->file;
  if (const auto* environment = std::get_if<log::Environment>(&action)) return environment->file;
  if (const auto* camera = std::get_if<log::Camera>(&action)) return camera->file;
  return {};
}

Error at_line(const LogFiles& files, std::int64_t line, const Error& error) {
  return {error.code, fmt::format("{}:{}: {}", files.log_name(), line, error.message)};
}

Result<void> note_event(const log::Event& event, LogFiles& files, LogPlan& plan) {
  ++plan.events;
  plan.last_time_us = event.time_us;
  plan.undo.add(event);
  if (const auto* touch = std::get_if<log::Touch>(&event.action)) {
    ++plan.touches;
    if (touch->phase == log::TouchPhase::kDown) ++plan.strokes;
  } else if (const auto* color = std::get_if<log::Color>(&event.action)) {
    plan.palette.pick(*color);
  } else if (std::holds_alternative<log::Step>(event.action)) {
    plan.stepped = true;
    ++plan.steps;
  }
  const std::string file = named_file(event.action);
  if (file.empty()) return {};
  Result<std::string> path = std::holds_alternative<log::Camera>(event.action)
                                 ? files.use_camera(file)
                                 : files.use_picture(file);
  if (path) return {};
  return at_line(files, event.line, path.error());
}
}  // namespace

Result<LogPlan> plan_log(log::Reader& reader, LogFiles& files,
                         const std::vector<StopPoint>& stops_wanted, const PaintMaker& maker,
                         const Control& control, StampBudget* budget) {
  Result<Palette> palette = Palette::make(reader.header().palette, maker);
  if (!palette) return palette.error();
  LogPlan plan;
  plan.palette = std::move(*palette);
  StopFinder finder(stops_wanted);
  while (true) {
    if (Result<void> go = control.go_on(); !go) return go.error();
    Result<std::optional<log::Event>> event = reader.next();
    if (!event) return event.error();
    if (!event->has_value()) break;
    if (Result<void> noted = note_event(**event, files, plan); !noted) return noted.error();
    if (budget != nullptr) {
      if (const Result<void> within = budget->add(**event); !within)
        return at_line(files, (*event)->line, within.error());
    }
    finder.add(**event);
  }
  const double steps_per_second = reader.header().steps_per_second;
  if (!plan.stepped && plan.events > 0) {
    plan.steps = StepClock(steps_per_second).step_of(plan.last_time_us) + 1;
  }
  Result<std::vector<std::int64_t>> stops = finder.resolve(steps_per_second, plan.steps);
  if (!stops) return stops.error();
  plan.stops = std::move(*stops);
  plan.sha256 = reader.sha256();
  plan.salvaged = reader.salvaged();
  if (Result<void> back = reader.rewind(); !back) return back.error();
  return plan;
}

}  // namespace pentimento
