#pragma once
// Jobs that are interrupted and go on, again and again.

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <utility>
#include <vector>

#include "replay/commands/render.h"

namespace pentimento::test {

struct Survived {
  Result<JobReport> report;  // of the run that came to the end
  int interruptions = 0;
  std::vector<std::string> warnings;
};

/// A control that interrupts a job after so many steps that are computed.
class InterruptingControl {
 public:
  explicit InterruptingControl(int steps) {
    control.cancelled = &cancelled_;
    control.progress = [this, steps](const ProgressState& state) {
      if (state.phase == "simulate" && ++computed_ == steps) cancelled_ = true;
    };
  }
  InterruptingControl(const InterruptingControl&) = delete;
  InterruptingControl& operator=(const InterruptingControl&) = delete;
  Control control;

 private:
  std::atomic<bool> cancelled_{false};
  int computed_ = 0;
};

/// Renders with an interruption after every `steps` steps that are computed, each time as in a new
/// process. `between(n)` is called after interruption n.
template <typename Between>
Survived survive(const RenderJob& job, int steps, const Between& between) {
  Survived survived{Error{ErrorCode::kInterrupted, {}}, 0, {}};
  while (survived.interruptions < 100'000) {
    InterruptingControl interrupting(steps);
    interrupting.control.warn = [&](const std::string& text) { survived.warnings.push_back(text); };
    survived.report = render(job, interrupting.control);
    if (survived.report || survived.report.error().code != ErrorCode::kInterrupted) return survived;
    between(++survived.interruptions);
  }
  return survived;
}

inline Survived survive(const RenderJob& job, int steps) {
  return survive(job, steps, [](int) {});
}

/// Interrupts the job once, after `steps` steps.
inline Error interrupt(const RenderJob& job, int steps) {
  const InterruptingControl interrupting(steps);
  Result<JobReport> done = render(job, interrupting.control);
  EXPECT_FALSE(done) << "it came to its end";
  return done ? Error{} : done.error();
}

/// What must be the same with and without interruptions: hashes, account, measurements.
inline std::string comparable(const JobReport& report) {
  JobReport same = report;
  same.wall_s = 0;
  same.peak_memory_bytes = 0;
  same.phases.clear();
  same.checkpoint.reset();
  return report_json(same);
}

}  // namespace pentimento::test
