#include "cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "cli/command.h"
#include "formats/io/utf8.h"
#include "replay/job/report_object.h"

namespace pentimento::cli {

namespace {
constexpr double kTerminalInterval_s = 0.1;
constexpr double kNdjsonInterval_s = 0.5;

double seconds(std::chrono::steady_clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

std::string terminal_line(const ProgressState& state, double per_s, double left_s) {
  if (state.total == 0) return fmt::format("{}", state.phase);
  const double percent = 100.0 * static_cast<double>(state.done) / static_cast<double>(state.total);
  constexpr int kBar = 24;
  const int filled = static_cast<int>(percent * kBar / 100);
  std::string bar(static_cast<std::size_t>(filled), '#');
  bar.resize(kBar, '.');
  return fmt::format("{:<9} [{}] {:5.1f} %  {:.0f}/s  {:.0f} s left", state.phase, bar, percent,
                     per_s, left_s);
}

std::string ndjson_line(const ProgressState& state, double per_s, double left_s) {
  ReportObject json;
  json.add("phase", state.phase).add("done", state.done).add("total", state.total);
  if (state.total > 0) {
    json.add("percent", 100.0 * static_cast<double>(state.done) / static_cast<double>(state.total))
        .add("per_s", per_s)
        .add("left_s", left_s);
  }
  return json.text();
}
}  // namespace

Result<ProgressMode> progress_mode(const std::string& name, bool quiet) {
  if (name != "auto" && name != "tty" && name != "ndjson" && name != "none") {
    return Error{ErrorCode::kUsage, "--progress " + name + ": expected auto, tty, ndjson or none"};
  }
  if (quiet || name == "none") return ProgressMode::kNone;
  if (name == "ndjson") return ProgressMode::kNdjson;
  if (name == "tty" || isatty(STDERR_FILENO) == 1) return ProgressMode::kTerminal;
  return ProgressMode::kNone;
}

ProgressPrinter::~ProgressPrinter() {
  clear_line();
}

void ProgressPrinter::clear_line() {
  if (line_open_) std::fputs("\r\033[K", stderr);
  line_open_ = false;
}

/// Progress is shown at the start and the end of a phase, and a few times in between.
bool ProgressPrinter::is_due(const ProgressState& state) {
  const Clock::time_point now = Clock::now();
  const bool first = state.phase != phase_;
  if (first) {
    phase_ = state.phase;
    phase_began_ = now;
  }
  const double interval_s =
      mode_ == ProgressMode::kTerminal ? kTerminalInterval_s : kNdjsonInterval_s;
  const bool last = state.total > 0 && state.done >= state.total;
  if (!first && !last && seconds(now - shown_) < interval_s) return false;
  shown_ = now;
  return true;
}

void ProgressPrinter::show(const ProgressState& state) {
  if (mode_ == ProgressMode::kNone || !is_due(state)) return;
  const double run_s = seconds(shown_ - phase_began_);
  const double per_s = run_s > 0 ? static_cast<double>(state.done) / run_s : 0;
  const double left_s = per_s > 0 ? static_cast<double>(state.total - state.done) / per_s : 0;
  if (mode_ == ProgressMode::kNdjson) {
    std::fprintf(stderr, "%s\n", ndjson_line(state, per_s, left_s).c_str());
    return;
  }
  std::fprintf(stderr, "\r\033[K%s", terminal_line(state, per_s, left_s).c_str());
  std::fflush(stderr);
  line_open_ = true;
}

void ProgressPrinter::say(const std::string& text) {
  clear_line();
  if (mode_ == ProgressMode::kNdjson) {
    std::fprintf(stderr, "%s\n", ReportObject().add("warning", text).text().c_str());
  } else {
    std::fprintf(stderr, "pentimento: %s\n", one_line(text).c_str());
  }
}

int ProgressPrinter::fail(const Error& error) {
  clear_line();
  if (mode_ != ProgressMode::kNdjson) return cli::fail(error);
  const int code = exit_code(error.code);
  ReportObject line;
  line.add("error", error.message).add("exit_code", code);
  std::fprintf(stderr, "%s\n", line.text().c_str());
  return code;
}

void ProgressPrinter::conclude(const std::string& text, const std::string& json) {
  clear_line();
  if (mode_ == ProgressMode::kNdjson) {
    std::fprintf(stderr, "{\"report\":%s}\n", json.c_str());
  } else {
    std::fputs(text.c_str(), stderr);
  }
}

}  // namespace pentimento::cli
