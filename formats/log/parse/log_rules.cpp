#include "formats/log/parse/log_rules.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/brush/builtin_brushes.h"
#include "formats/log/json/nearest_name.h"
#include "formats/log/stream/resolve.h"
#include "formats/log/tables/event_names.h"
#include "formats/log/tables/model_fields.h"
#include "formats/log/tables/slider_fields.h"

namespace pentimento::log {

namespace {

Error bad(std::string message) {
  return {ErrorCode::kBadInput, std::move(message)};
}
/// `more than 5 events, the limit (--max-events)`
Error over_limit(const Limits& limits, std::int64_t Limits::*limit, std::string_view what) {
  return {ErrorCode::kLimit,
          fmt::format("more than {} {}{}", limits.*limit, what, limit_note(limit))};
}

/// `brush "rund" is unknown (did you mean "round"?)`
Error unknown_name(std::string_view what, std::string_view name,
                   const std::set<std::string, std::less<>>& known) {
  const std::vector<std::string_view> names(known.begin(), known.end());
  return bad(fmt::format("{} \"{}\" is unknown{}", what, name, did_you_mean(name, names)));
}

}  // namespace

LogRules::LogRules(const Header& header, const ReaderOptions& options)
    : options_(options), steps_per_second_(header.steps_per_second), model_(header.model) {
  for (const PigmentSpec& pigment : header.palette) pigments_.insert(pigment.name);
  for (const BrushSpec& brush : header.brushes) brushes_.insert(brush.name);
  for (const std::string& name : builtin_brush_names()) brushes_.insert(name);
}

Result<void> LogRules::check(const Event& event) {
  if (++events_ > options_.limits.max_events) {
    return over_limit(options_.limits, &Limits::max_events, "events");
  }
  const Result<void> time = check_time(event);
  if (!time) return time;
  return std::visit([&](const auto& action) { return check_action(action); }, event.action);
}

Result<void> LogRules::check_time(const Event& event) {
  const double time_s = static_cast<double>(event.time_us) * 1e-6;
  if (event.time_us < last_us_) {
    return bad(fmt::format("t {} is before {}, the time of the event before", time_s,
                           static_cast<double>(last_us_) * 1e-6));
  }
  last_us_ = event.time_us;
  const double steps = time_s * steps_per_second_;
  if (steps > static_cast<double>(options_.limits.max_steps)) {
    return Error{ErrorCode::kLimit,
                 fmt::format("t {} is step {:.0f}, over {} steps{}", time_s, steps,
                             options_.limits.max_steps, limit_note(&Limits::max_steps))};
  }
  return {};
}

Result<void> LogRules::check_action(const Touch& touch) {
  if (touch.phase == TouchPhase::kMove && !down_.empty() && down_.back() == touch.id) return {};
  const auto found = std::find(down_.begin(), down_.end(), touch.id);
  if (touch.phase == TouchPhase::kDown) {
    if (found != down_.end()) {
      return bad(fmt::format("phase \"down\" of id {}, which is down already", touch.id));
    }
    if (static_cast<std::int64_t>(down_.size()) >= options_.limits.max_touches)
      return over_limit(options_.limits, &Limits::max_touches, "touches at once");
    down_.push_back(touch.id);
    return {};
  }
  if (found == down_.end()) {
    return bad(
        fmt::format("phase \"{}\" of id {}, which is not down", phase_name(touch.phase), touch.id));
  }
  if (touch.phase != TouchPhase::kMove) down_.erase(found);
  return {};
}

Result<void> LogRules::check_action(const Slider& slider) {
  const ModelField* field = find_model_field(slider.name);
  if (field == nullptr) return {};
  Model changed = model_;
  set_model_value(*field, changed, slider.value);
  std::string problem = model_problem(changed);
  if (!problem.empty()) return bad(std::move(problem));
  model_ = changed;
  return {};
}

Result<void> LogRules::check_action(const Color& color) {
  if (!color.value) {
    if (pigments_.contains(color.pigment)) return {};
    return unknown_name("pigment", color.pigment, pigments_);
  }
  colors_.insert(*color.value);
  if (static_cast<std::int64_t>(colors_.size()) <= options_.limits.max_colors) return {};
  return over_limit(options_.limits, &Limits::max_colors, "different colours");
}

Result<void> LogRules::check_action(const BrushChange& brush) {
  if (brushes_.contains(brush.name)) return {};
  return unknown_name("brush", brush.name, brushes_);
}

Result<void> LogRules::check_file(const std::string& name) const {
  std::string problem = file_name_problem(name, options_.allow_outside);
  if (problem.empty()) return {};
  return bad(std::move(problem));
}

Result<void> LogRules::check_action(const Load& load) {
  return check_file(load.file);
}

Result<void> LogRules::check_action(const Environment& environment) {
  if (environment.sh) return {};
  return check_file(environment.file);
}

Result<void> LogRules::check_action(const Camera& camera) {
  return check_file(camera.file);
}

Result<void> LogRules::check_action(const Step&) {
  if (++steps_ <= options_.limits.max_steps) return {};
  return over_limit(options_.limits, &Limits::max_steps, "steps");
}

std::string header_over_limit(const Header& header, const Limits& limits) {
  if (static_cast<std::int64_t>(header.palette.size()) > limits.max_pigments)
    return over_limit(limits, &Limits::max_pigments, "pigments").message;
  if (static_cast<std::int64_t>(header.brushes.size()) > limits.max_brushes)
    return over_limit(limits, &Limits::max_brushes, "brushes").message;
  return {};
}

std::string header_file_problem(const Header& header, bool allow_outside) {
  std::string problem = file_name_problem(header.paper.texture, allow_outside);
  if (!problem.empty()) return "paper.texture: " + problem;
  for (std::size_t i = 0; i < header.brushes.size(); ++i) {
    if (header.brushes[i].texture.empty()) continue;
    problem = file_name_problem(header.brushes[i].texture, allow_outside);
    if (!problem.empty()) return fmt::format("brushes[{}].texture: {}", i, problem);
  }
  return {};
}

}  // namespace pentimento::log
