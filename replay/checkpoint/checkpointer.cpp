#include "replay/checkpoint/checkpointer.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "replay/checkpoint/disk_probe.h"

namespace pentimento {

namespace {
// Saving may take so much of the time that the run has taken up to then.
constexpr double kMostOfTime_frac = 0.03;
// What is written to learn how fast the disk is, until a slot tells: enough for a disk of 1 GB/s to
// be measured beside kLeastCost_s, and no more than a second on one of 16 MB/s.
constexpr int kProbe_MiB = 16;
constexpr double kProbe_bytes = kProbe_MiB * 1048576.0;
// The disk that the probe itself is paid for as, and that stands where the probe fails: a slow one.
constexpr double kSlowDisk_bytes_per_s = 1e8;
// Many disks write the first bytes faster than the following.
constexpr double kHoldsOfProbe_frac = 0.5;
// What every slot costs, however small, in three waits for the disk.
constexpr double kLeastCost_s = 0.03;
// How long an interrupted job works on the step that it is in. The signal shall be obeyed within
// two seconds, and the slot takes some of them.
constexpr double kLongestStep_s = 1;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// The guide's planes as they lie in memory: more than the slot takes.
std::int64_t guide_bytes(const CanvasState& state) {
  constexpr std::int64_t kOtherPlanes = 5;  // depth, velocities, base, strokes
  const std::int64_t planes =
      kOtherPlanes + state.bands + std::int64_t{state.layers} * state.channels;
  return planes * state.geometry.width * state.geometry.height *
         static_cast<std::int64_t>(sizeof(float));
}
}  // namespace

Checkpointer::Checkpointer(const CheckpointChoice& choice, const Control& control,
                           std::unique_ptr<SlotFolder> folder)
    : choice_(choice), control_(control), folder_(std::move(folder)), planes_(choice.folder) {
  report_.folder = choice.folder;
}

Result<std::unique_ptr<Checkpointer>> Checkpointer::open(const CheckpointChoice& choice,
                                                         const Control& control) {
  Result<std::unique_ptr<SlotFolder>> folder = SlotFolder::open(choice.folder);
  if (!folder) return folder.error();
  return std::unique_ptr<Checkpointer>(new Checkpointer(choice, control, std::move(*folder)));
}

Result<void> Checkpointer::begin(const ReplayParts& parts, Binding binding) {
  parts_.emplace(parts);
  binding_ = std::move(binding);
  tried_step_ = parts.simulation.state().step;
  const std::vector<std::uint64_t> slots = folder_->slots();
  if (slots.empty()) return {};
  std::string first_problem;
  for (const std::uint64_t generation : slots) {
    Result<Slot> slot = take(generation);
    if (slot) {
      report_.older_slot = !first_problem.empty();
      if (report_.older_slot) control_.warning(first_problem + "; the slot before it is used");
      return go_on_from(generation, std::move(*slot));
    }
    const ErrorCode code = slot.error().code;
    if (code != ErrorCode::kBadInput && code != ErrorCode::kIo) return slot.error();
    if (first_problem.empty()) first_problem = slot.error().message;
  }
  return Error{ErrorCode::kBadInput,
               fmt::format("{}; no slot in {} is whole: remove the folder to begin anew",
                           first_problem, folder_->path())};
}

/// Reads and checks a slot, and brings back what lies in files beside it. If that fails, another
/// slot can still be tried.
Result<Slot> Checkpointer::take(std::uint64_t generation) {
  const std::string name = folder_->slot_file(generation);
  const Result<checkpoint::SlotParts> parts = checkpoint::read_slot(name);
  if (!parts) return parts.error();
  const Result<Binding> kept = binding_in(*parts, name);
  if (!kept) return kept.error();
  if (const std::string other = difference(*kept, binding_); !other.empty())
    return Error{ErrorCode::kUsage, fmt::format("{}: it was saved for {}", name, other)};
  const CanvasState& state = parts_->simulation.state();
  const int detail = follower() == nullptr ? 1 : follower()->canvas().layout().factor();
  Result<Slot> slot = decode_slot(
      *parts, {{state.geometry, state.layers, state.channels, state.bands}, detail}, name);
  if (!slot) return slot;
  if (slot->stops_done >= parts_->files.size()) {
    return Error{ErrorCode::kBadInput,
                 fmt::format("{}: part \"position\": it has more stops than this job", name)};
  }
  if (!parts_->simulation.fits(slot->memory)) {
    return Error{ErrorCode::kBadInput,
                 fmt::format("{}: part \"memory\": what its brushes hold does not fit", name)};
  }
  if (slot->detail) {
    Result<void> recalled =
        planes_.recall(*slot->detail, std::move(slot->planes), slot->guide, *follower());
    if (!recalled) return recalled.error();
  }
  if (Result<void> kept_outputs =
          parts_->outputs.recall(slot->outputs, folder_->path(), parts_->files);
      !kept_outputs)
    return kept_outputs.error();
  return slot;
}

/// The player moves, and no other slot can be tried after that.
Result<void> Checkpointer::go_on_from(std::uint64_t generation, Slot slot) {
  if (Result<void> skipped = parts_->player.skip_to(slot.position); !skipped) return skipped;
  std::set<int> down;
  for (const TouchMemory& touch : slot.memory.touches)
    if (touch.down) down.insert(touch.id);
  if (down != parts_->player.touches_down()) {
    return Error{ErrorCode::kBadInput,
                 fmt::format("{}: its touches are not those of the log: remove the folder to begin "
                             "anew",
                             folder_->slot_file(generation))};
  }
  parts_->simulation.recall(std::move(slot.guide), slot.memory);
  newest_ = generation;
  stops_done_ = slot.stops_done;
  saved_ = now();
  tried_step_ = saved_->step;
  report_.resumed_step = slot.step;
  return {};
}

Checkpointer::Moment Checkpointer::now() const {
  return {parts_->simulation.state().step, parts_->player.position().cues, stops_done_};
}

DetailFollower* Checkpointer::follower() const {
  return parts_->detail == nullptr ? nullptr : &parts_->detail->follower();
}

void Checkpointer::stop_done() {
  ++stops_done_;
  parts_->outputs.stop_done();
}

bool Checkpointer::is_due() {
  if (choice_.every_steps) {
    const std::int64_t n = *choice_.every_steps;
    return parts_->simulation.state().step / n != tried_step_ / n;
  }
  return seconds_since(tried_at_) >= choice_.every_s && is_affordable();
}

bool Checkpointer::has_time_for(double cost_s) const {
  return report_.wall_s + cost_s <= kMostOfTime_frac * seconds_since(begun_);
}

bool Checkpointer::is_affordable() {
  constexpr double kProbeCost_s = kLeastCost_s + kProbe_bytes / kSlowDisk_bytes_per_s;
  if (!bytes_per_s_ && !has_time_for(kProbeCost_s)) return false;
  if (!bytes_per_s_) bytes_per_s_ = probed_bytes_per_s();
  return has_time_for(expected_cost_s());
}

double Checkpointer::probed_bytes_per_s() {
  const std::string file = folder_->slot_file(folder_->next_generation()) + ".part";
  const Result<double> taken_s = time_of_writing_s(file, kProbe_MiB);
  if (!taken_s) return kSlowDisk_bytes_per_s;  // the slot will say what is wrong
  report_.wall_s += *taken_s;
  return kHoldsOfProbe_frac * kProbe_bytes / *taken_s;
}

double Checkpointer::expected_cost_s() const {
  std::int64_t bytes = slot_bytes_ > 0 ? slot_bytes_ : guide_bytes(parts_->simulation.state());
  if (const DetailFollower* detail = follower()) bytes += planes_.bytes_to_save(*detail);
  return kLeastCost_s + static_cast<double>(bytes) / bytes_per_s_.value_or(kSlowDisk_bytes_per_s);
}

Result<void> Checkpointer::between_steps() {
  if (!control_.go_on()) return interrupted();
  if (is_due()) save_or_warn();
  return {};
}

Result<void> Checkpointer::within_step() {
  const Result<void> go = control_.go_on();
  if (go) return {};
  if (!interrupted_at_) interrupted_at_ = Clock::now();
  return seconds_since(*interrupted_at_) < kLongestStep_s ? Result<void>() : go;
}

void Checkpointer::before_outputs(bool last_stop) {
  const bool wanted = choice_.every_steps ? last_stop : is_affordable();
  if (wanted) save_or_warn();
}

void Checkpointer::save_or_warn() {
  const Result<void> saved = save();
  if (!saved) control_.warning(saved.error().message + "; this moment is not saved");
}

Result<void> Checkpointer::save() {
  if (saved_ == now()) return {};
  const Clock::time_point begin = Clock::now();
  if (DetailFollower* detail = follower()) {
    detail->finish_stamps();
    if (const Result<void>& whole = detail->canvas().problem(); !whole) return whole;
  }
  Result<void> written = write(folder_->next_generation());
  // Also of one that failed: not again before the time or the step has come.
  tried_at_ = Clock::now();
  tried_step_ = parts_->simulation.state().step;
  const double cost_s = std::chrono::duration<double>(tried_at_ - begin).count();
  report_.wall_s += cost_s;
  if (!written) return written;
  const std::int64_t bytes = slot_bytes_ + planes_.bytes_saved();
  bytes_per_s_ = static_cast<double>(bytes) / std::max(cost_s, kLeastCost_s);
  report_.bytes_written += bytes;
  ++report_.slots_written;
  saved_ = now();
  return {};
}

/// The planes first, the slot that needs them last. Then what no slot needs goes away.
Result<void> Checkpointer::write(std::uint64_t generation) {
  Slot slot;
  slot.binding = binding_;
  slot.position = parts_->player.position();
  slot.step = parts_->simulation.state().step;
  slot.stops_done = stops_done_;
  Result<std::vector<KeptOutput>> kept = parts_->outputs.keep(folder_->path());
  if (!kept) return kept.error();
  slot.outputs = std::move(*kept);
  slot.memory = parts_->simulation.memory();
  DetailFollower* detail = follower();
  if (detail != nullptr) {
    slot.detail = {detail->checkpoint(), detail->lock_statistics()};
    Result<checkpoint::PlaneIndex> planes = planes_.save(*detail, generation);
    if (!planes) return planes.error();
    slot.planes = std::move(*planes);
  }
  Result<std::uint64_t> bytes =
      write_slot(folder_->slot_file(generation), slot, parts_->simulation.state());
  if (!bytes) return bytes.error();
  slot_bytes_ = static_cast<std::int64_t>(*bytes);
  std::set<std::uint64_t> slots = {generation}, needed = slot.planes.generations();
  if (newest_) slots.insert(*newest_);
  needed.merge(planes_.index().generations());
  if (detail != nullptr) planes_.commit(std::move(slot.planes), *detail);
  folder_->keep_only(slots, needed);
  newest_ = generation;
  return {};
}

Error Checkpointer::interrupted() {
  if (!parts_->player.is_between_steps())
    return {ErrorCode::kInterrupted,
            fmt::format("interrupted within a long step, which is not saved; {}",
                        saved_ ? fmt::format("the same command goes on from step {}", saved_->step)
                               : "the same command begins anew")};
  if (Result<void> saved = save(); !saved)
    return {saved.error().code, "interrupted, and not saved: " + saved.error().message};
  return {ErrorCode::kInterrupted,
          fmt::format("interrupted at step {}; the same command goes on from {}", saved_->step,
                      folder_->path())};
}

CheckpointReport Checkpointer::finish() {
  folder_->clear();
  return report_;
}

}  // namespace pentimento
