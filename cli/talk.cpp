#include "cli/talk.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>

#include "cli/signals.h"
#include "replay/output/effective.h"

namespace pentimento::cli {

namespace {
constexpr std::array<std::string_view, 9> kLeftOut = {
    "-o",        "--output", "--progress",   "--threads",         "--memory-limit",
    "--scratch", "--hashes", "--checkpoint", "--checkpoint-every"};
constexpr std::array<std::string_view, 4> kLeftOutFlags = {"--json", "--quiet", "--no-clobber",
                                                           "--dry-run"};

template <std::size_t N>
bool is_among(const std::array<std::string_view, N>& names, std::string_view word) {
  return std::find(names.begin(), names.end(), word) != names.end();
}
}  // namespace

Control make_control(ProgressPrinter& printer, const TalkOptions& talk) {
  Control control;
  control.cancelled = &watch_signals();
  control.progress = [&printer](const ProgressState& state) { printer.show(state); };
  if (!talk.quiet) control.warn = [&printer](const std::string& text) { printer.say(text); };
  return control;
}

int report(const JobReport& done, const TalkOptions& talk, ProgressPrinter& printer) {
  if (talk.json) return print(report_json(done) + "\n");
  if (!talk.quiet) printer.conclude(report_text(done), report_json(done));
  return 0;
}

std::string command_line(const std::string& command, const Arguments& arguments) {
  std::string line = "pentimento " + command;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    const std::string_view name = std::string_view(word).substr(0, word.find('='));
    if (is_among(kLeftOutFlags, word)) continue;
    if (is_among(kLeftOut, name)) {
      if (name == word) ++i;  // its value is the next word
      continue;
    }
    if (word.size() > 2 && word.starts_with("-o")) continue;
    line.push_back(' ');
    line.append(shell_word(word));
  }
  return line;
}

}  // namespace pentimento::cli
