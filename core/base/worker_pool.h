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
  /// but the last, and returns when all are done. The first range is the caller's. A loop inside of
  /// a loop, and a loop in a process that was forked off, is done by its caller alone. What `body`
  /// throws is thrown here; then some ranges may be left out.
  void share(int begin, int end, int grain_size, const std::function<void(int, int)>& body);

  /// From now on workers that wait for a loop call piece(), which does a piece of work, or returns
  /// false if there is none left. A loop does not wait for a piece. `piece` must stay until
  /// withdraw().
  void offer(const std::function<bool()>& piece);
  /// Takes the offer back, and returns when no worker is at a piece any more. What a piece threw is
  /// thrown here.
  void withdraw();

 private:
  void work();
  bool enter(std::uint32_t& seen);
  void leave();
  void take_ranges(std::int64_t from) noexcept;
  bool do_piece();
  void open_loop();
  void close_loop();

  /// The loop that is shared now; written only while no worker is inside.
  struct Loop {
    const std::function<void(int, int)>* body = nullptr;
    std::int64_t end = 0;
    std::int64_t piece = 1;
  };

  std::vector<std::thread::native_handle_type> threads_;
  const int process_;
  std::atomic<bool> busy_{false};
  std::atomic<std::uint32_t> state_{0};  // see worker_pool.cpp
  std::atomic<std::uint32_t> left_{0};   // how often the last worker has left a closed loop
  std::atomic<bool> ending_{false};
  std::atomic<std::int64_t> next_{0};  // of the loop: where the next range begins
  Loop loop_;
  std::atomic<bool> thrown_{false};
  std::exception_ptr problem_;
  std::atomic<const std::function<bool()>*> piece_{nullptr};  // what is offered
  std::atomic<int> at_pieces_{0};                             // workers that may be at one
  std::atomic<bool> piece_thrown_{false};
  std::exception_ptr piece_problem_;
};

}  // namespace pentimento
