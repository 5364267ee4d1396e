#pragma once
// The points at which a replay stops: `--at 12.5`, `--at step:300`, `--at mark:NAME`. A time or a
// mark means the end of the step in which it falls; so does the end of a log.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "formats/log/tables/events.h"

namespace pentimento {

struct StopPoint {
  enum class Kind { kTime, kStep, kMark };
  Kind kind = Kind::kTime;
  std::int64_t value = 0;  // microseconds, or steps
  std::string mark;
  std::string label;  // what was written after the colon, fit for a file name
};

/// Errors: kUsage.
Result<StopPoint> parse_stop_point(const std::string& text);

/// Finds the steps at which the points lie while the log is read once.
class StopFinder {
 public:
  explicit StopFinder(std::vector<StopPoint> points);

  /// Feeds the log, event by event.
  void add(const log::Event& event);
  /// Call it after the last event. Returns for each point how many steps are done there, in the
  /// order of the points. Errors: kUsage for a point after the log's end (`steps` in all) or a mark
  /// that the log does not have.
  Result<std::vector<std::int64_t>> resolve(double steps_per_second, std::int64_t steps) const;

 private:
  struct Found {
    std::optional<std::int64_t> time_us;  // of a mark
    std::int64_t steps_before = 0;        // `step` events before the point
  };
  std::vector<StopPoint> points_;
  std::vector<Found> found_;
  std::int64_t step_events_ = 0;
  std::int64_t last_time_us_ = 0;
};

}  // namespace pentimento
