#pragma once
// Undo and redo are resolved before anything is played: an undone unit is never simulated, so it
// leaves no trace. A unit is one stroke (from the `down` of a touch), one `dry`, one `clear` or one
// `load`. Units are numbered in the order in which they begin. Gravity, sliders, colours and time
// are no units and stay. As in every painting program, nothing can be redone after a new unit. An
// undo or redo with nothing to act on does nothing, but is counted.

#include <cstdint>
#include <vector>

#include "formats/log/tables/events.h"

namespace pentimento {

class UndoTable {
 public:
  /// Feeds the log, event by event, in its order.
  void add(const log::Event& event);

  /// How many units the log begins, played or not.
  std::int64_t units() const { return static_cast<std::int64_t>(played_.size()); }
  /// Whether unit `index` (from 0, in the order in which they begin) is played.
  bool played(std::int64_t index) const { return played_[static_cast<std::size_t>(index)]; }
  /// Undo and redo events that found nothing to act on.
  std::int64_t idle() const { return idle_; }

  /// Whether the event begins a unit.
  static bool begins_unit(const log::Action& action);

 private:
  struct OpenTouch {
    std::int64_t id;
    std::uint32_t unit;
  };
  void begin(const log::Action& action);
  void undo();
  void redo();
  void cancel(std::int64_t id);
  void forget_touch(std::int64_t id);

  std::vector<bool> played_;
  std::vector<std::uint32_t> done_;    // units in effect, the newest last
  std::vector<std::uint32_t> undone_;  // units that redo would bring back, the next last
  std::vector<OpenTouch> open_;
  std::int64_t idle_ = 0;
};

}  // namespace pentimento
