#include "core/base/threads.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <optional>
#include <thread>

namespace pentimento {

namespace {
constexpr int kRowsPerTask = 8;  // a 1024-cell row is a few microseconds; tasks cost about one

int machine_threads() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

int resolved(int count) {
  return count > 0 ? count : machine_threads();
}
}  // namespace

struct Threads::Arena {
  explicit Arena(int n) : count(n), arena(n) {
    if (n > machine_threads()) {
      // Without this TBB complains on standard error that it gives fewer threads than asked for.
      more_workers.emplace(tbb::global_control::max_allowed_parallelism,
                           static_cast<std::size_t>(n));
    }
  }
  int count;
  bool backwards = false;
  std::optional<tbb::global_control> more_workers;
  mutable tbb::task_arena arena;
};

Threads::Threads(int count) : arena_(std::make_unique<Arena>(resolved(count))) {}
Threads Threads::backwards() {
  Threads threads(1);
  threads.arena_->backwards = true;
  return threads;
}
Threads::~Threads() = default;
Threads::Threads(Threads&&) noexcept = default;
Threads& Threads::operator=(Threads&&) noexcept = default;

int Threads::count() const {
  return arena_->count;
}

void Threads::for_ranges(int begin, int end, int grain_size,
                         const std::function<void(int, int)>& body) const {
  if (end <= begin) return;
  if (arena_->backwards) {
    for (int last = end; last > begin; last -= std::min(grain_size, last - begin))
      body(std::max(begin, last - grain_size), last);
    return;
  }
  if (arena_->count == 1 || end - begin <= grain_size) {
    body(begin, end);
    return;
  }
  arena_->arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<int>(begin, end, static_cast<std::size_t>(grain_size)),
                      [&](const tbb::blocked_range<int>& r) { body(r.begin(), r.end()); });
  });
}

void Threads::for_rows(int rows, const std::function<void(int)>& body) const {
  for_ranges(0, rows, kRowsPerTask, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) body(y);
  });
}

}  // namespace pentimento
