#pragma once
// Parallel loops over rows. Which thread does which rows is left open, so a body may depend on
// nothing but its own rows: results are the same for any number of threads.

#include <functional>
#include <memory>

namespace pentimento {

class Threads {
 public:
  /// `count` threads, the calling one included; 0 = all the machine has.
  explicit Threads(int count = 1);
  /// One thread that takes the smallest ranges from the last to the first: what depends on the
  /// order shows. For tests.
  static Threads backwards();
  ~Threads();
  Threads(Threads&&) noexcept;
  Threads& operator=(Threads&&) noexcept;

  int count() const;
  /// Calls body(begin, end) on disjoint ranges that cover [begin, end). `grain_size` is the
  /// smallest range worth handing out. Returns when all are done.
  void for_ranges(int begin, int end, int grain_size,
                  const std::function<void(int, int)>& body) const;
  /// Calls body(y) for each row y of [0, rows).
  void for_rows(int rows, const std::function<void(int)>& body) const;

 private:
  struct Arena;
  std::unique_ptr<Arena> arena_;
};

}  // namespace pentimento
