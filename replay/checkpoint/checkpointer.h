#pragma once
// Saves a replay now and then, and brings it back (docs/checkpoints.md).

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "core/base/result.h"
#include "core/simulation/simulation.h"
#include "replay/checkpoint/binding.h"
#include "replay/checkpoint/saved_planes.h"
#include "replay/checkpoint/slot.h"
#include "replay/checkpoint/slot_folder.h"
#include "replay/job/control.h"
#include "replay/job/render_job.h"
#include "replay/job/report.h"
#include "replay/output/output_plan.h"
#include "replay/output/output_set.h"
#include "replay/play/player.h"
#include "replay/play/replay_detail.h"
#include "replay/play/step_pause.h"

namespace pentimento {

/// What is saved and brought back. All outlive the checkpointer.
struct ReplayParts {
  Simulation& simulation;
  ReplayDetail* detail = nullptr;  // if there is one
  Player& player;
  OutputSet& outputs;
  const std::vector<std::vector<PlannedOutput>>& files;  // of each stop
};

class Checkpointer final : public StepPause {
 public:
  /// `choice` and `control` outlive the checkpointer. Errors: those of the folder.
  static Result<std::unique_ptr<Checkpointer>> open(const CheckpointChoice& choice,
                                                    const Control& control);

  /// Whether there is a slot to go on from.
  bool has_slots() const { return !folder_->slots().empty(); }
  /// Takes the parts, which stand before their first step. Brings them to the newest slot that is
  /// whole, if there is one. Errors: kUsage for slots of another job; kBadInput if no slot is
  /// whole.
  Result<void> begin(const ReplayParts& parts, Binding binding);

  /// Stops of the replay whose outputs are complete.
  std::size_t stops_done() const { return stops_done_; }
  void stop_done();

  /// Saves if it is time to. Errors: kInterrupted, when all is saved.
  Result<void> between_steps() override;
  /// Lets a step come to its end when the job is interrupted, unless the step is a long one.
  Result<void> within_step() override;
  /// The replay rests at a stop, and its outputs are about to be made, which may take long.
  void before_outputs(bool last_stop);
  /// The job was interrupted: saves, unless a step is half done. Returns the error that ends the
  /// job.
  Error interrupted();
  /// The job is done and its outputs have their names: the slots go away.
  CheckpointReport finish();

 private:
  Checkpointer(const CheckpointChoice& choice, const Control& control,
               std::unique_ptr<SlotFolder> folder);
  /// The moment that a slot holds.
  struct Moment {
    std::int64_t step = 0, cues = 0;
    std::size_t stops_done = 0;
    friend bool operator==(const Moment&, const Moment&) = default;
  };
  Moment now() const;
  DetailFollower* follower() const;
  Result<Slot> take(std::uint64_t generation);
  Result<void> go_on_from(std::uint64_t generation, Slot slot);
  bool is_due();
  /// Whether all slots together stay within their share of the time, this one included. Measures
  /// the disk when it is asked first.
  bool is_affordable();
  bool has_time_for(double cost_s) const;
  double probed_bytes_per_s();
  double expected_cost_s() const;
  Result<void> save();
  Result<void> write(std::uint64_t generation);
  void save_or_warn();

  const CheckpointChoice& choice_;
  const Control& control_;
  std::unique_ptr<SlotFolder> folder_;
  std::optional<ReplayParts> parts_;
  Binding binding_;
  SavedPlanes planes_;
  std::optional<std::uint64_t> newest_;  // the generation of the newest slot
  std::size_t stops_done_ = 0;
  std::int64_t tried_step_ = 0;  // where it was last saved or could not be; at first the beginning
  std::optional<Moment> saved_;
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begun_ = Clock::now();
  Clock::time_point tried_at_ = begun_;
  std::optional<Clock::time_point> interrupted_at_;  // heard within a step
  std::int64_t slot_bytes_ = 0;        // of the last slot without its planes; 0: none yet
  std::optional<double> bytes_per_s_;  // of the probe, then of the last slot
  CheckpointReport report_;
};

}  // namespace pentimento
