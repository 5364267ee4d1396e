#pragma once
// Plays a timeline into a simulation, step by step, as far as the caller wants. Idle time costs
// nothing: if a step changed nothing, the steps up to the next cue are skipped, which gives the
// same state.

#include <cstdint>
#include <optional>
#include <set>

#include "core/base/result.h"
#include "core/simulation/simulation.h"
#include "replay/job/control.h"
#include "replay/play/hand.h"
#include "replay/play/lighting_track.h"
#include "replay/play/step_observer.h"
#include "replay/play/step_pause.h"
#include "replay/timeline/timeline.h"

namespace pentimento {

/// All references must outlive the player.
struct PlayerInput {
  Timeline& timeline;
  Simulation& simulation;
  Hand& hand;
  LightingTrack& lighting;
  LogFiles& files;
  const Control& control;
  std::int64_t total_steps = 0;      // for progress
  StepObserver* observer = nullptr;  // told of every step that was computed; nullptr: nobody
  StepPause* pause = nullptr;  // told of each pause between steps, where a signal ends the replay;
                               // nullptr: a signal ends it anywhere
};

/// How far a replay is: with the canvas and what the simulation remembers, all that it takes to go
/// on.
struct PlayPosition {
  std::int64_t cues = 0;      // played
  std::int64_t computed = 0;  // steps, without those that were skipped
};

class Player {
 public:
  explicit Player(const PlayerInput& input);

  /// Plays all cues and steps before step `end_step`. Errors: kNonFinite with step and cell,
  /// kInterrupted, and those of the log and its files.
  Result<void> play_to(std::int64_t end_step);
  /// Plays all cues that are left, and steps up to `end_step`.
  Result<void> play_all(std::int64_t end_step);

  /// Steps up to `end_step` without playing cues.
  Result<void> settle(std::int64_t end_step);

  PlayPosition position() const { return {cues_, computed_}; }
  /// Runs the timeline up to a position without playing: hand and light follow, the canvas does
  /// not. Call it first; then the simulation recalls the canvas that belongs to the position.
  /// Errors: as above, and kBadInput for a position that the log does not have.
  Result<void> skip_to(const PlayPosition& position);
  /// The touches that are down where it skipped to.
  const std::set<int>& touches_down() const { return in_.hand.followed_down(); }

  /// Whether nothing of a step is half done: no cue was played since the last step.
  bool is_between_steps() const { return cues_ == cues_of_whole_steps_; }
  /// Steps since the player began.
  std::int64_t steps() const;
  /// Steps that were computed, not skipped.
  std::int64_t steps_computed() const { return computed_; }

 private:
  /// Plays the cues before a step; without a limit, all cues that are left.
  Result<void> apply_cues(std::optional<std::int64_t> before_step);
  /// Makes `ahead_` the next cue. False at the end of the log.
  Result<bool> look_ahead();
  /// Whether a signal ends the replay where it is: not within a step if there is a pause.
  bool may_stop_here() const { return in_.pause == nullptr || is_between_steps(); }
  /// Errors: kInterrupted.
  Result<void> hear() const;
  Result<void> light(const Cue& cue);
  Result<void> advance(std::int64_t to_step);
  Result<void> check_finite() const;

  PlayerInput in_;
  std::int64_t first_step_;
  std::int64_t computed_ = 0;
  std::int64_t cues_ = 0;  // played
  std::int64_t cues_of_whole_steps_ = 0;
  bool whole_canvas_ = false;  // a drying, a clearing or a picture since the last step
  std::int64_t line_ = 0;      // of the log, of the last cue that was played
  std::optional<Cue> ahead_;
};

}  // namespace pentimento
