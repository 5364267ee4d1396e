#include "cli/checkpoint_options.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <charconv>
#include <string_view>

#include "cli/values.h"

namespace pentimento::cli {

namespace {
constexpr std::string_view kSteps = "step:";
}  // namespace

void CheckpointOptions::add_to(CLI::App& app) {
  app.add_option("--checkpoint", folder,
                 "a folder where the work is saved: after an interruption the same command goes on")
      ->type_name("DIR");
  app.add_option("--checkpoint-every", every,
                 "how often it is saved: 30s, 10m, 2h, or step:N for every N steps (10m)")
      ->type_name("WHEN");
}

Result<CheckpointChoice> CheckpointOptions::choice() const {
  CheckpointChoice choice;
  choice.folder = folder;
  if (every.empty()) return choice;
  if (folder.empty()) return Error{ErrorCode::kUsage, "--checkpoint-every: needs --checkpoint DIR"};
  if (!every.starts_with(kSteps)) {
    Result<double> seconds = parse_duration("--checkpoint-every", every);
    if (!seconds) return seconds.error();
    choice.every_s = *seconds;
    return choice;
  }
  std::int64_t steps = 0;
  const char* const end = every.data() + every.size();
  const auto [rest, problem] = std::from_chars(every.data() + kSteps.size(), end, steps);
  if (problem != std::errc{} || rest != end || steps < 1)
    return Error{ErrorCode::kUsage, "--checkpoint-every " + every + ": expected step:N, N from 1"};
  choice.every_steps = steps;
  return choice;
}

}  // namespace pentimento::cli
