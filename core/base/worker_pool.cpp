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
constexpr std::int64_t kPiecesPerThread = 8;
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
}  // namespace

WorkerPool::WorkerPool(int wanted) : process_(::getpid()) {
  const int count = std::clamp(wanted, 0, kMostWorkers);
  threads_.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const auto thread = start_plain_thread([this] { work(); });
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

void WorkerPool::work() {
  std::uint32_t seen = 0;
  int yields = 0;
  for (;;) {
    if (ending_.load(std::memory_order_acquire)) return;
    if (enter(seen)) {
      take_ranges(next_.fetch_add(loop_.piece, std::memory_order_relaxed));
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

void WorkerPool::take_ranges(std::int64_t from) noexcept {
  try {
    for (; from < loop_.end; from = next_.fetch_add(loop_.piece, std::memory_order_relaxed)) {
      (*loop_.body)(static_cast<int>(from),
                    static_cast<int>(std::min(loop_.end, from + loop_.piece)));
    }
  } catch (...) {
    next_.store(loop_.end, std::memory_order_relaxed);
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
  const std::int64_t length = std::int64_t{end} - begin;
  const std::int64_t pieces = kPiecesPerThread * (workers() + 1);
  loop_ = {&body, end, std::max<std::int64_t>(grain_size, (length + pieces - 1) / pieces)};
  next_.store(begin + loop_.piece, std::memory_order_relaxed);
  open_loop();
  take_ranges(begin);
  close_loop();
  busy_.store(false);
  if (thrown_.exchange(false)) std::rethrow_exception(std::exchange(problem_, nullptr));
}

}  // namespace pentimento
