#include "core/base/threads.h"

#include <algorithm>
#include <thread>

#include "core/base/thread_count.h"
#include "core/base/worker_pool.h"

namespace pentimento {

namespace {
constexpr int kRowsPerTask = 8;  // a 1024-cell row is a few microseconds; tasks cost about one
}  // namespace

int wanted_threads(int count) {
  if (count > 0) return count;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

struct Threads::Arena {
  explicit Arena(int count) : pool(count - 1) {}
  bool backwards = false;
  WorkerPool pool;
};

Threads::Threads(int count) : arena_(std::make_unique<Arena>(wanted_threads(count))) {}
Threads Threads::backwards() {
  Threads threads(1);
  threads.arena_->backwards = true;
  return threads;
}
Threads::~Threads() = default;
Threads::Threads(Threads&&) noexcept = default;
Threads& Threads::operator=(Threads&&) noexcept = default;

int Threads::count() const {
  return arena_->pool.workers() + 1;
}

void Threads::for_ranges(int begin, int end, int grain_size,
                         const std::function<void(int, int)>& body) const {
  if (end <= begin) return;
  if (arena_->backwards) {
    for (int last = end; last > begin; last -= std::min(grain_size, last - begin))
      body(std::max(begin, last - grain_size), last);
    return;
  }
  if (end - begin <= grain_size) return body(begin, end);
  arena_->pool.share(begin, end, grain_size, body);
}

void Threads::offer(const std::function<bool()>& piece) const {
  arena_->pool.offer(piece);
}

void Threads::withdraw() const {
  arena_->pool.withdraw();
}

void Threads::for_rows(int rows, const std::function<void(int)>& body) const {
  for_ranges(0, rows, kRowsPerTask, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) body(y);
  });
}

}  // namespace pentimento
