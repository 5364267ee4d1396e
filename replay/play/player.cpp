#include "replay/play/player.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace pentimento {

namespace {
/// To look for values that are not finite reads every plane, which takes as long as four steps of a
/// painting session. A fault is named up to so many steps late: six seconds of painting.
constexpr std::int64_t kStepsBetweenChecks = 256;

bool changes_whole_canvas(const log::Action& action) {
  return std::holds_alternative<log::Dry>(action) || std::holds_alternative<log::Clear>(action) ||
         std::holds_alternative<log::Load>(action);
}
}  // namespace

Player::Player(const PlayerInput& input) : in_(input), first_step_(input.simulation.state().step) {}

std::int64_t Player::steps() const {
  return in_.simulation.state().step - first_step_;
}

Result<void> Player::play_to(std::int64_t end_step) {
  if (Result<void> applied = apply_cues(end_step); !applied) return applied;
  if (Result<void> advanced = advance(end_step); !advanced) return advanced;
  return check_finite();
}

Result<void> Player::play_all(std::int64_t end_step) {
  if (Result<void> applied = apply_cues(std::nullopt); !applied) return applied;
  if (Result<void> advanced = advance(end_step); !advanced) return advanced;
  return check_finite();
}

Result<void> Player::settle(std::int64_t end_step) {
  if (Result<void> advanced = advance(end_step); !advanced) return advanced;
  return check_finite();
}

Result<void> Player::apply_cues(std::optional<std::int64_t> before_step) {
  while (true) {
    const Result<bool> more = look_ahead();
    if (!more) return more.error();
    if (!*more) return {};
    if (before_step && ahead_->step >= *before_step) return {};
    if (Result<void> go = hear(); !go) return go;
    if (Result<void> advanced = advance(ahead_->step); !advanced) return advanced;
    line_ = std::max(line_, ahead_->line);
    if (Result<void> applied = in_.hand.apply(*ahead_, in_.timeline.peek()); !applied)
      return applied;
    if (Result<void> lit = light(*ahead_); !lit) return lit;
    ahead_.reset();
    ++cues_;
  }
}

Result<void> Player::hear() const {
  return may_stop_here() ? in_.control.go_on() : in_.pause->within_step();
}

Result<bool> Player::look_ahead() {
  if (ahead_) return true;
  Result<std::optional<Cue>> cue =
      in_.timeline.next(may_stop_here() ? in_.control.cancelled : nullptr);
  if (!cue) return cue.error();
  ahead_ = std::move(*cue);
  return ahead_.has_value();
}

/// What an action of the log changes beside the paint.
Result<void> Player::light(const Cue& cue) {
  const auto* action = std::get_if<log::Action>(&cue.what);
  if (action == nullptr) return {};
  whole_canvas_ = whole_canvas_ || changes_whole_canvas(*action);
  return in_.lighting.follow(*action, cue.step, in_.files);
}

Result<void> Player::skip_to(const PlayPosition& position) {
  PENTIMENTO_CHECK(cues_ == 0 && computed_ == 0);
  while (cues_ < position.cues) {
    if (Result<void> go = in_.control.go_on(); !go) return go;
    const Result<bool> more = look_ahead();
    if (!more) return more.error();
    if (!*more) return Error{ErrorCode::kBadInput, "the log ends before the position in it"};
    line_ = std::max(line_, ahead_->line);
    if (Result<void> followed = in_.hand.follow(*ahead_); !followed) return followed;
    if (Result<void> lit = light(*ahead_); !lit) return lit;
    ahead_.reset();
    ++cues_;
  }
  cues_of_whole_steps_ = cues_;
  computed_ = position.computed;
  return {};
}

Result<void> Player::advance(std::int64_t to_step) {
  while (steps() < to_step) {
    if (in_.pause == nullptr) {
      if (Result<void> go = in_.control.go_on(); !go) return go;
    }
    ++computed_;
    const bool moved = in_.simulation.step();
    cues_of_whole_steps_ = cues_;
    if (in_.observer != nullptr) {
      const bool whole = std::exchange(whole_canvas_, false);
      if (Result<void> seen = in_.observer->stepped(in_.simulation.state(), line_, whole); !seen)
        return seen;
    }
    if (computed_ % kStepsBetweenChecks == 0) {
      if (Result<void> finite = check_finite(); !finite) return finite;
    }
    if (!moved && steps() < to_step) in_.simulation.skip(to_step - steps());
    in_.control.report({"simulate", steps(), in_.total_steps});
    if (in_.pause != nullptr) {
      if (Result<void> paused = in_.pause->between_steps(); !paused) return paused;
    }
  }
  return {};
}

Result<void> Player::check_finite() const {
  const std::string where = in_.simulation.first_non_finite();
  if (where.empty()) return {};
  return Error{ErrorCode::kNonFinite,
               fmt::format("step {}: {} is not finite", in_.simulation.state().step, where)};
}

}  // namespace pentimento
