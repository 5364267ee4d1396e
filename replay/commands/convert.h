#pragma once
// `pentimento convert`: another program's recording becomes an action log, and a log another log.

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "core/base/result.h"
#include "formats/import/gravity_file.h"
#include "formats/import/sketch/recording.h"
#include "formats/import/sketch/sketch_log.h"
#include "formats/log/tables/reader_options.h"
#include "replay/job/control.h"

namespace pentimento {

/// What is done to the log before it is written, in this order.
struct LogEdits {
  std::string merged_log;    // painted at the same time; empty: none
  std::string gravity_file;  // replaces gravity; empty: none
  sketch::GravityOptions gravity;
  std::optional<std::pair<double, double>> trim_s;  // from, to
  std::optional<double> longest_idle_s;
  double speed = 1;
  std::optional<double> resample_hz;
  std::optional<std::pair<double, double>> canvas_m;  // width, height
  double size_factor = 1;
  std::optional<double> spline_error_m;  // samples that strokes do not need are left out
};

struct ConvertJob {
  std::string input;
  std::string output = "-";  // standard output
  std::string format;        // of formats(), or "log"; empty: told from the content
  sketch::ReadOptions reading;
  sketch::LogOptions writing;
  log::ReaderOptions log_reading;
  LogEdits edits;
  bool no_clobber = false;
  /// Asked before a log is read and before anything is written: until then a signal may end the
  /// process. May be empty.
  std::function<Control()> control;
};

struct ConvertFacts {
  std::string input, format;
  std::int64_t strokes = 0, samples = 0;  // of the input
  std::int64_t log_strokes = 0, log_samples = 0, events = 0;
  double duration_s = 0, canvas_width_m = 0, canvas_height_m = 0;
  sketch::Report report;
  Published log;
};

/// Errors: kUsage (an unknown format), kBadInput, kLimit, kIo, kInterrupted. A log on standard
/// input needs format "log".
Result<ConvertFacts> convert(const ConvertJob& job);

std::string convert_json(const ConvertFacts& facts);
std::string convert_text(const ConvertFacts& facts);

}  // namespace pentimento
