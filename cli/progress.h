#pragma once
// Shows the progress of a job on standard error: on a terminal as a line that rewrites itself, for
// programs as a JSON object per line, or not at all.

#include <chrono>
#include <string>

#include "core/base/result.h"
#include "replay/job/control.h"

namespace pentimento::cli {

enum class ProgressMode { kNone, kTerminal, kNdjson };

/// The mode of a name. `auto` is the terminal mode if standard error is a terminal. Errors: kUsage.
Result<ProgressMode> progress_mode(const std::string& name, bool quiet);

class ProgressPrinter {
 public:
  explicit ProgressPrinter(ProgressMode mode) : mode_(mode) {}
  /// Ends the line that is being rewritten.
  ~ProgressPrinter();
  ProgressPrinter(const ProgressPrinter&) = delete;
  ProgressPrinter& operator=(const ProgressPrinter&) = delete;

  void show(const ProgressState& state);
  /// Prints a warning without tearing the progress line; for programs {"warning":TEXT}.
  void say(const std::string& text);
  /// Prints an error likewise; for programs {"error":TEXT,"exit_code":N}. Returns the exit code.
  int fail(const Error& error);
  /// Prints the closing report likewise: `text`, or for programs {"report":`json`}.
  void conclude(const std::string& text, const std::string& json);

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
