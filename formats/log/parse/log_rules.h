#pragma once
// The rules of a log that concern several lines: time, touches, names, limits.

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "formats/log/tables/events.h"
#include "formats/log/tables/reader_options.h"

namespace pentimento::log {

class LogRules {
 public:
  LogRules(const Header& header, const ReaderOptions& options);

  /// Takes the next event. Errors, without file and line: kBadInput, kLimit.
  Result<void> check(const Event& event);

 private:
  Result<void> check_time(const Event& event);
  Result<void> check_action(const Touch& touch);
  Result<void> check_action(const Slider& slider);
  Result<void> check_action(const Color& color);
  Result<void> check_action(const BrushChange& brush);
  Result<void> check_action(const Load& load);
  Result<void> check_action(const Environment& environment);
  Result<void> check_action(const Camera& camera);
  Result<void> check_action(const Step& step);
  template <typename T>
  Result<void> check_action(const T&) {
    return {};
  }
  Result<void> check_file(const std::string& name) const;

  ReaderOptions options_;
  double steps_per_second_;
  std::set<std::string, std::less<>> pigments_, brushes_;
  Model model_;
  std::int64_t last_us_ = 0, events_ = 0, steps_ = 0;
  std::vector<std::int64_t> down_;  // ids
  std::set<Rgb> colors_;
};

/// Which limit the header is over; empty if none.
std::string header_over_limit(const Header& header, const Limits& limits);

/// What is wrong with the names of files in a header; empty if nothing.
std::string header_file_problem(const Header& header, bool allow_outside);

}  // namespace pentimento::log
