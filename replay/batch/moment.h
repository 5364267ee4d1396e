#pragma once
// The time of day, for people who read a run's files.

#include <ctime>
#include <string>

namespace pentimento {

/// As 2026-11-23T19:00:00Z.
inline std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32];
  return {text, std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

}  // namespace pentimento
