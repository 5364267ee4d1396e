#pragma once
// Threads that share a loop with the one that calls it. They are made once and wait between loops.
// A machine that gives fewer threads than asked for, or none, is no error: the loop is shared among
// those that there are.

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <thread>
#include <vector>

namespace pentimento {

class WorkerPool {
 public:
  /// Makes `wanted` workers, or as many as the machine gives.
  explicit WorkerPool(int wanted);
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  int workers() const { return static_cast<int>(threads_.size()); }

  /// Calls body(from, to) on disjoint ranges that cover [begin, end), each of at least `grain_size`
  /// but the last, and returns when all are done. Loops of the same length are shared in the same
  /// way, as far as all threads keep up: what a thread has written in one, it finds near its core
  /// in the next. The first range is the caller's. A loop inside of a loop, and a loop in a process
  /// that was forked off, is done by its caller alone. What `body` throws is thrown here; then some
  /// ranges may be left out.
  void share(int begin, int end, int grain_size, const std::function<void(int, int)>& body);

  /// From now on workers that wait for a loop call piece(), which does a piece of work, or returns
  /// false if there is none left. A loop does not wait for a piece. `piece` must stay until
  /// withdraw().
  void offer(const std::function<bool()>& piece);
  /// Takes the offer back, and returns when no worker is at a piece any more. What a piece threw is
  /// thrown here.
  void withdraw();

 private:
  void work(std::size_t thread);
  bool enter(std::uint32_t& seen);
  void leave();
  void share_out(std::int64_t ranges);
  void do_ranges(std::size_t thread) noexcept;
  void do_range(std::int64_t range) const;
  bool do_piece();
  void open_loop();
  void close_loop();

  /// The loop that is shared now; written only while no worker is inside.
  struct Loop {
    const std::function<void(int, int)>* body = nullptr;
    std::int64_t begin = 0, end = 0;
    std::int64_t length = 1;  // of a range
  };
  /// Which ranges of the loop are left of a thread's share. In a cache line of its own.
  struct alignas(64) ThreadShare {
    std::atomic<std::uint64_t> left{0};  // see worker_pool.cpp
  };

  std::vector<std::thread::native_handle_type> threads_;
  const int process_;
  std::atomic<bool> busy_{false};
  std::atomic<std::uint32_t> state_{0};  // see worker_pool.cpp
  std::atomic<std::uint32_t> left_{0};   // how often the last worker has left a closed loop
  std::atomic<bool> ending_{false};
  Loop loop_;
  std::vector<ThreadShare> shares_;  // the caller's, and one for each worker
  std::atomic<bool> thrown_{false};
  std::exception_ptr problem_;
  std::atomic<const std::function<bool()>*> piece_{nullptr};  // what is offered
  std::atomic<int> at_pieces_{0};                             // workers that may be at one
  std::atomic<bool> piece_thrown_{false};
  std::exception_ptr piece_problem_;
};

}  // namespace pentimento
