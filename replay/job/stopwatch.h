#pragma once
// Wall time of the phases of a job.

#include <chrono>
#include <string>
#include <vector>

#include "replay/job/report.h"

namespace pentimento {

class Stopwatch {
 public:
  /// From now until the next call, time counts for `phase`.
  void start(const std::string& phase) {
    stop();
    for (current_ = 0; current_ < phases_.size(); ++current_) {
      if (phases_[current_].name == phase) return;
    }
    phases_.push_back({phase, 0});
  }
  void stop() {
    const Clock::time_point now = Clock::now();
    if (current_ < phases_.size()) phases_[current_].wall_s += seconds(lap_, now);
    current_ = phases_.size();
    lap_ = now;
  }
  double total_s() const { return seconds(begin_, Clock::now()); }
  const std::vector<Phase>& phases() const { return phases_; }

 private:
  using Clock = std::chrono::steady_clock;
  static double seconds(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
  }
  Clock::time_point begin_ = Clock::now();
  Clock::time_point lap_ = begin_;
  std::vector<Phase> phases_;
  std::size_t current_ = 0;
};

}  // namespace pentimento
