#include "replay/timeline/cue_queue.h"

#include <algorithm>
#include <utility>

namespace pentimento {

namespace {
/// A max-heap of "later" has the earliest in front. Arrivals differ, so the order is total.
bool later(const PendingCue& a, const PendingCue& b) {
  if (a.cue.time_us != b.cue.time_us) return a.cue.time_us > b.cue.time_us;
  if (a.place != b.place) return a.place > b.place;
  return a.arrival > b.arrival;
}
}  // namespace

void CueQueue::push(PendingCue pending) {
  pending.arrival = arrivals_++;
  heap_.push_back(std::move(pending));
  std::push_heap(heap_.begin(), heap_.end(), later);
}

PendingCue CueQueue::pop() {
  std::pop_heap(heap_.begin(), heap_.end(), later);
  PendingCue first = std::move(heap_.back());
  heap_.pop_back();
  return first;
}

}  // namespace pentimento
