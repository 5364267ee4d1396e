#pragma once
// A queue of cues that wait for their turn, in the order of (time, place in the log, arrival).

#include <cstdint>
#include <vector>

#include "formats/log/tables/events.h"
#include "replay/timeline/cue.h"

namespace pentimento {

struct PendingCue {
  Cue cue;
  std::int64_t place = 0;    // of the event that it comes from, in the log
  std::int64_t arrival = 0;  // set by the queue
};

class CueQueue {
 public:
  void push(PendingCue pending);
  bool empty() const { return heap_.empty(); }
  std::size_t size() const { return heap_.size(); }
  const PendingCue& front() const { return heap_.front(); }
  PendingCue pop();

 private:
  std::vector<PendingCue> heap_;
  std::int64_t arrivals_ = 0;
};

}  // namespace pentimento
