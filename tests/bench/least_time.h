#pragma once
// The least processor time of an iteration: what a loop takes when nothing disturbs it. The mean
// that Google Benchmark gives grows with all that other programs do to the caches meanwhile.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <limits>

namespace pentimento {

/// Processor time of the calling thread, ns.
inline double thread_time_ns() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

class LeastTime {
 public:
  /// Times one iteration. It should last microseconds: reading the clock takes some tenths of one.
  template <typename Body>
  void time(const Body& body) {
    const double begin_ns = thread_time_ns();
    body();
    least_ns_ = std::min(least_ns_, thread_time_ns() - begin_ns);
  }
  /// Notes the least time as the counter ns_least, of one of the `items` of an iteration.
  void report(benchmark::State& run, double items) const {
    run.counters["ns_least"] = least_ns_ / items;
  }

 private:
  double least_ns_ = std::numeric_limits<double>::infinity();
};

}  // namespace pentimento
