#pragma once
// What one hand paints with: brush, sliders of the brush, colours. For two hands that take turns.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "formats/log/tables/events.h"

namespace pentimento::log {

class HandSettings {
 public:
  /// As a log begins: brush `round`, the default of every slider, the first pigment of the palette.
  explicit HandSettings(const Header& header);

  /// Keeps the event if it is one of these settings. Returns whether it is.
  bool take(const Event& event);

  /// The events at `time_us` that make these settings of others; none if they are the same.
  std::vector<Event> changes_from(const HandSettings& others, std::int64_t time_us) const;

 private:
  std::string brush_ = "round";
  std::map<std::string, double, std::less<>> sliders_;
  std::vector<Color> colors_;  // the first is of the whole width, later ones lie over it
};

}  // namespace pentimento::log
