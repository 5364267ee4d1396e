#pragma once
// Where a replay is to stop: `--at 12.5`, `--at step:300`, `--at mark:NAME`. A time or a mark means
// the end of the step that it falls in, as the end of a log does.

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
  /// After the last event: for each point the steps done there, in the order given. Errors: kUsage
  /// for a point behind the log's end (`steps` in all) or a mark that it does not have.
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
