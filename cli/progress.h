#pragma once
// How far a job is, on standard error: a line that rewrites itself on a terminal, a JSON object per
// line for programs, or nothing.

#include <chrono>
#include <string>

#include "core/base/result.h"
#include "replay/job/control.h"

namespace pentimento::cli {

enum class ProgressMode { kNone, kTerminal, kNdjson };

/// `auto`: on a terminal if standard error is one. Errors: kUsage.
Result<ProgressMode> progress_mode(const std::string& name, bool quiet);

class ProgressPrinter {
 public:
  explicit ProgressPrinter(ProgressMode mode) : mode_(mode) {}
  /// Ends the line that is being rewritten.
  ~ProgressPrinter();
  ProgressPrinter(const ProgressPrinter&) = delete;
  ProgressPrinter& operator=(const ProgressPrinter&) = delete;

  void show(const ProgressState& state);
  /// A line of words between; it does not tear the progress line.
  void say(const std::string& text);

 private:
  using Clock = std::chrono::steady_clock;
  bool is_due(const ProgressState& state);
  void clear_line();

  ProgressMode mode_;
  std::string phase_;
  Clock::time_point phase_began_;
  Clock::time_point shown_;
  bool line_open_ = false;
};

}  // namespace pentimento::cli
