#include "core/base/worker_pool.h"

#include <pthread.h>
#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "core/base/plain_thread.h"

namespace pentimento {

namespace {
// Ranges for each thread: enough that one that is held up does not hold up the loop.
constexpr std::int64_t kRangesPerThread = 16;
// How often a worker offers its core before it sleeps, for some 0.3 ms: loops of a step follow one
// another within tens of microseconds, steps of small paintings within hundreds, and to be woken
// takes some ten.
constexpr int kYields = 1000;

// The state: how many workers are inside of the loop, whether it is open, and which loop it is.
constexpr std::uint32_t kInside = 0xfff;
constexpr std::uint32_t kOpen = 0x1000;
constexpr std::uint32_t kLoop = 0x2000;
constexpr int kMostWorkers = 0xfff;

std::uint32_t loop_of(std::uint32_t state) {
  return state & ~(kInside | kOpen);
}

// What is left of a share: the ranges [from, to), `to` in the upper half.
constexpr std::uint64_t kTo = std::uint64_t{1} << 32;
constexpr std::uint64_t kFrom = kTo - 1;
constexpr std::int64_t kNone = -1;

/// Takes a range from the front of what is left, or from the back. kNone if none is left.
std::int64_t take(std::atomic<std::uint64_t>& left, bool from_front) {
  std::uint64_t now = left.load(std::memory_order_relaxed);
  while ((now & kFrom) < now / kTo) {
    if (!left.compare_exchange_weak(now, from_front ? now + 1 : now - kTo,
                                    std::memory_order_relaxed))
      continue;
    return static_cast<std::int64_t>(from_front ? now & kFrom : now / kTo - 1);
  }
  return kNone;
}
}  // namespace

WorkerPool::WorkerPool(int wanted)
    : process_(::getpid()),
      shares_(static_cast<std::size_t>(std::clamp(wanted, 0, kMostWorkers)) + 1) {
  threads_.reserve(shares_.size());
  for (std::size_t i = 1; i < shares_.size(); ++i) {
    const auto thread = start_plain_thread([this, i] { work(i); });
    if (!thread) break;
    threads_.push_back(*thread);
  }
}

WorkerPool::~WorkerPool() {
  if (::getpid() != process_) return;  // the threads are those of the parent
  ending_.store(true);
  open_loop();
  for (const pthread_t thread : threads_) pthread_join(thread, nullptr);
}

void WorkerPool::work(std::size_t thread) {
  std::uint32_t seen = 0;
  int yields = 0;
  for (;;) {
    if (ending_.load(std::memory_order_acquire)) return;
    if (enter(seen)) {
      do_ranges(thread);
      leave();
      yields = 0;
    } else if (do_piece()) {
      yields = 0;
    } else if (yields < kYields) {
      ++yields;
      sched_yield();
    } else {
      const std::uint32_t state = state_.load(std::memory_order_acquire);
      const bool is_new = (state & kOpen) != 0 && loop_of(state) != seen;
      if (!is_new && !ending_.load(std::memory_order_acquire)) state_.wait(state);
    }
  }
}

/// Joins the loop if it is open and not the one that this worker has already done.
bool WorkerPool::enter(std::uint32_t& seen) {
  std::uint32_t state = state_.load(std::memory_order_acquire);
  while ((state & kOpen) != 0 && loop_of(state) != seen) {
    if (!state_.compare_exchange_weak(state, state + 1, std::memory_order_acq_rel)) continue;
    seen = loop_of(state);
    return true;
  }
  return false;
}

void WorkerPool::leave() {
  const std::uint32_t after = state_.fetch_sub(1, std::memory_order_acq_rel) - 1;
  if ((after & (kInside | kOpen)) != 0) return;
  left_.fetch_add(1, std::memory_order_release);
  left_.notify_one();
}

/// Gives each thread as many of the ranges, side by side; the first is the caller's alone. No
/// worker may be inside.
void WorkerPool::share_out(std::int64_t ranges) {
  const auto threads = static_cast<std::int64_t>(threads_.size()) + 1;
  std::int64_t from = 1;
  for (std::int64_t i = 0; i < threads; ++i) {
    const std::int64_t to = (ranges * (i + 1) + threads - 1) / threads;
    shares_[static_cast<std::size_t>(i)].left.store(
        static_cast<std::uint64_t>(to) * kTo + static_cast<std::uint64_t>(from),
        std::memory_order_relaxed);
    from = std::max(from, to);
  }
}

void WorkerPool::do_range(std::int64_t range) const {
  const std::int64_t from = loop_.begin + range * loop_.length;
  (*loop_.body)(static_cast<int>(from), static_cast<int>(std::min(loop_.end, from + loop_.length)));
}

/// Does the share of this thread, then what the others have not come to, from its end.
void WorkerPool::do_ranges(std::size_t thread) noexcept {
  try {
    if (thread == 0) do_range(0);
    for (std::size_t k = 0; k < shares_.size(); ++k) {
      std::atomic<std::uint64_t>& left = shares_[(thread + k) % shares_.size()].left;
      for (std::int64_t range = take(left, k == 0); range != kNone; range = take(left, k == 0))
        do_range(range);
    }
  } catch (...) {
    for (ThreadShare& share : shares_) share.left.store(0, std::memory_order_relaxed);
    if (!thrown_.exchange(true)) problem_ = std::current_exception();
  }
}

/// Does a piece of what is offered. False if nothing is.
bool WorkerPool::do_piece() {
  if (piece_.load(std::memory_order_relaxed) == nullptr) return false;
  // Whoever withdraws the offer sees either this worker here, or that it found none.
  at_pieces_.fetch_add(1);
  const std::function<bool()>* piece = piece_.load();
  bool done = false;
  try {
    done = piece != nullptr && (*piece)();
  } catch (...) {
    if (!piece_thrown_.exchange(true)) piece_problem_ = std::current_exception();
  }
  at_pieces_.fetch_sub(1);
  return done;
}

void WorkerPool::offer(const std::function<bool()>& piece) {
  if (threads_.empty() || ::getpid() != process_) return;
  piece_.store(&piece);
  // Another number wakes the workers that sleep; the loop of that number is not open.
  state_.fetch_add(kLoop, std::memory_order_acq_rel);
  state_.notify_all();
}

void WorkerPool::withdraw() {
  piece_.store(nullptr);
  while (::getpid() == process_ && at_pieces_.load() != 0) sched_yield();
  if (piece_thrown_.exchange(false)) std::rethrow_exception(std::exchange(piece_problem_, nullptr));
}

void WorkerPool::open_loop() {
  // The number of the loop goes on, and wraps; a worker never sleeps through so many.
  const std::uint32_t state = state_.load(std::memory_order_relaxed);
  state_.store((loop_of(state) + kLoop) | kOpen, std::memory_order_release);
  state_.notify_all();
}

/// From here on nobody enters; waits for those who are inside.
void WorkerPool::close_loop() {
  state_.fetch_and(~kOpen, std::memory_order_acq_rel);
  for (int yields = 0;;) {
    const std::uint32_t left = left_.load(std::memory_order_acquire);
    if ((state_.load(std::memory_order_acquire) & kInside) == 0) return;
    if (yields++ < kYields) {
      sched_yield();
    } else {
      left_.wait(left);
    }
  }
}

void WorkerPool::share(int begin, int end, int grain_size,
                       const std::function<void(int, int)>& body) {
  if (threads_.empty() || ::getpid() != process_ || busy_.exchange(true)) return body(begin, end);
  const std::int64_t all = std::int64_t{end} - begin;
  const std::int64_t most = kRangesPerThread * (workers() + 1);
  const std::int64_t length = std::max<std::int64_t>(grain_size, (all + most - 1) / most);
  loop_ = {&body, begin, end, length};
  share_out((all + length - 1) / length);
  open_loop();
  do_ranges(0);
  close_loop();
  busy_.store(false);
  if (thrown_.exchange(false)) std::rethrow_exception(std::exchange(problem_, nullptr));
}

}  // namespace pentimento
