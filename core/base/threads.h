#pragma once
// Parallel loops over rows. It is left open which thread does which rows, so a body must depend on
// its own rows alone. Then results are the same for any number of threads.

#include <functional>
#include <memory>

namespace pentimento {

class Threads {
 public:
  /// `count` threads, the calling one included; 0: as many as the machine has.
  explicit Threads(int count = 1);
  /// For tests: one thread that takes the smallest ranges from the last to the first, so that a
  /// result that depends on the order shows.
  static Threads backwards();
  ~Threads();
  Threads(Threads&&) noexcept;
  Threads& operator=(Threads&&) noexcept;

  int count() const;
  /// Calls body(begin, end) on disjoint ranges that cover [begin, end). `grain_size`, > 0, is the
  /// smallest range worth a task. Returns when all ranges are done.
  void for_ranges(int begin, int end, int grain_size,
                  const std::function<void(int, int)>& body) const;
  /// From now on threads that wait for a loop call piece(), which does a piece of work, or returns
  /// false if there is none left. The caller need not wait; but it, or a loop, must do what is left
  /// when it needs it. `piece` must stay until withdraw().
  void offer(const std::function<bool()>& piece) const;
  /// Takes the offer back, and returns when no thread is at a piece any more. What a piece threw is
  /// thrown here.
  void withdraw() const;
  /// Calls body(y) for each row y of [0, rows).
  void for_rows(int rows, const std::function<void(int)>& body) const;

 private:
  struct Arena;
  std::unique_ptr<Arena> arena_;
};

}  // namespace pentimento
