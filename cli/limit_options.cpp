#include "cli/limit_options.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "cli/range.h"

namespace pentimento::cli {

void LimitOptions::add_to(CLI::App& app, log::Limits& limits) {
  app.add_option("--max-events", limits.max_events, "refuse a log with more")
      ->check(in_range(1, 1e18))
      ->type_name("N");
  app.add_option("--max-steps", limits.max_steps, "refuse a log that takes more")
      ->check(in_range(1, 1e18))
      ->type_name("N");
  app.add_option("--max-line", limits.max_line_bytes, "refuse longer lines, bytes")
      ->check(in_range(1, 1e18))
      ->type_name("N");
  app.add_option("--limit", settings_,
                 "another limit of logs; repeatable (`pentimento list limits` has the names)")
      ->allow_extra_args(false)
      ->type_name("NAME=N");
}

Result<void> LimitOptions::complete(log::Limits& limits) const {
  for (const std::string& setting : settings_) {
    if (std::string problem = log::set_limit(limits, setting); !problem.empty())
      return Error{ErrorCode::kUsage, std::move(problem)};
  }
  return {};
}

}  // namespace pentimento::cli
