#pragma once
// Mends the events of a broken log: what a log may not have is dropped or put right.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "formats/log/tables/events.h"

namespace pentimento::log {

class Repair {
 public:
  /// What the event becomes. A time that runs back becomes that of the event before. A move without
  /// a down becomes one; an up or cancel without a down is dropped; before a down of a touch that
  /// is down, the touch is lifted where it was.
  std::vector<Event> mend(const Event& event);
  /// Lifts all touches that are down.
  std::vector<Event> finish();
  /// Notes a line that was dropped, and why.
  void drop(std::int64_t line, const std::string& problem);
  /// What was done, for people: counts, and the first few lines that were dropped.
  std::vector<std::string> notes() const;

 private:
  Event lift(std::int64_t id);

  std::int64_t last_us_ = 0;
  std::map<std::int64_t, Event> down_;  // the last sample of each touch that is down
  std::int64_t times_ = 0, lifted_ = 0, begun_ = 0, ends_ = 0, dropped_ = 0;
  std::vector<std::string> lines_;
};

}  // namespace pentimento::log
