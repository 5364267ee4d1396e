#pragma once
// Reads a dump once in a child process first. libhdf5 does not withstand every damaged file: a
// flipped byte in its tables can make it read outside its memory or loop. What happens to the child
// then becomes an error here, not the end of the programme.

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

#include "core/base/result.h"

namespace pentimento::hdf5 {

/// What the child may take before it knows what the file holds, and per byte of values after that.
struct RehearsalLimits {
  double seconds = 60;  // of wall time: many times what the tables of any dump take
  double bytes_per_second = 1e7;
  std::uint64_t bytes = std::uint64_t{1} << 30;  // of memory, beside what the parent has
};

/// Through which the reading says what it is about to read.
class Rehearsal {
 public:
  /// Of the reading that is no rehearsal: it has no limits.
  Rehearsal() = default;
  explicit Rehearsal(int pipe) : pipe_(pipe) {}
  bool real() const { return pipe_ < 0; }
  /// `bytes` of values will be read, and `held_bytes` of memory taken for them. Extends the limits.
  void expect(std::uint64_t bytes, std::uint64_t held_bytes) const;

 private:
  int pipe_ = -1;
};

/// Runs `read` in a child of this process and returns what it returned. The child ends with this
/// process, however that ends. Errors: those of `read`; kBadInput with `path` if the child dies or
/// takes longer than the limits; kInterrupted once `cancelled`, which may be nullptr, is set; kIo
/// if no child can be started.
Result<void> rehearse(const std::string& path, const std::atomic<bool>* cancelled,
                      const std::function<Result<void>(const Rehearsal&)>& read,
                      const RehearsalLimits& limits = {});

}  // namespace pentimento::hdf5
