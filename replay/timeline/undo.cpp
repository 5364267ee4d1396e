#include "replay/timeline/undo.h"

#include <algorithm>

namespace pentimento {

namespace {
/// Removes `unit`, which is near the end as a rule.
void forget(std::vector<std::uint32_t>& units, std::uint32_t unit) {
  const auto found = std::find(units.rbegin(), units.rend(), unit);
  if (found != units.rend()) units.erase(std::next(found).base());
}
}  // namespace

bool UndoTable::begins_unit(const log::Action& action) {
  if (const auto* touch = std::get_if<log::Touch>(&action)) {
    return touch->phase == log::TouchPhase::kDown;
  }
  return std::holds_alternative<log::Dry>(action) || std::holds_alternative<log::Clear>(action) ||
         std::holds_alternative<log::Load>(action);
}

void UndoTable::add(const log::Event& event) {
  if (begins_unit(event.action)) {
    begin(event.action);
  } else if (std::holds_alternative<log::Undo>(event.action)) {
    undo();
  } else if (std::holds_alternative<log::Redo>(event.action)) {
    redo();
  } else if (const auto* touch = std::get_if<log::Touch>(&event.action)) {
    if (touch->phase == log::TouchPhase::kCancel) cancel(touch->id);
    if (touch->phase != log::TouchPhase::kMove) forget_touch(touch->id);
  }
}

void UndoTable::begin(const log::Action& action) {
  const auto unit = static_cast<std::uint32_t>(played_.size());
  played_.push_back(true);
  done_.push_back(unit);
  undone_.clear();
  if (const auto* touch = std::get_if<log::Touch>(&action)) open_.push_back({touch->id, unit});
}

void UndoTable::undo() {
  if (done_.empty()) {
    ++idle_;
    return;
  }
  played_[done_.back()] = false;
  undone_.push_back(done_.back());
  done_.pop_back();
}

void UndoTable::redo() {
  if (undone_.empty()) {
    ++idle_;
    return;
  }
  played_[undone_.back()] = true;
  done_.push_back(undone_.back());
  undone_.pop_back();
}

/// The device took the touch back (a palm, a gesture). The stroke counts as never painted, and
/// cannot be redone.
void UndoTable::cancel(std::int64_t id) {
  const auto open =
      std::find_if(open_.begin(), open_.end(), [id](const OpenTouch& t) { return t.id == id; });
  if (open == open_.end()) return;
  played_[open->unit] = false;
  forget(done_, open->unit);
  forget(undone_, open->unit);
}

void UndoTable::forget_touch(std::int64_t id) {
  std::erase_if(open_, [id](const OpenTouch& t) { return t.id == id; });
}

}  // namespace pentimento
