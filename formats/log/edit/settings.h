#pragma once
// What a hand has set when a moment comes: the last event of each kind that holds until another one
// changes it.

#include <map>
#include <string>
#include <vector>

#include "formats/log/tables/events.h"

namespace pentimento::log {

class Settings {
 public:
  /// Keeps the event if it is a setting: gravity, slider, color, brush, light, environment, camera.
  /// Returns whether it is.
  bool take(const Event& event);
  /// All that is set, in the order in which it was, at another time.
  std::vector<Event> at(std::int64_t time_us) const;
  /// Forgets all.
  void clear();

 private:
  struct Kept {
    std::int64_t order = 0;
    Event event;
  };
  void keep(const std::string& key, const Event& event);
  std::map<std::string, Kept> kept_;
  std::int64_t order_ = 0;
};

}  // namespace pentimento::log
