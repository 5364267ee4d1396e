#pragma once
// A child process with a limit of time and of memory. It cannot take its parent with it: a crash, a
// hang and a want of memory are ways to end.

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace pentimento {

struct ChildSpec {
  std::string program;
  std::vector<std::string> words;  // after the program's name
  std::string folder;              // in which it runs
  std::string output_file;         // gets its standard output
  std::string message_file;        // gets its standard error
  double timeout_s = 600;
  std::int64_t memory_bytes = 0;  // that it may hold at a time; 0: no limit
};

enum class ChildEnd { kExit, kSignal, kTimeout, kMemory, kStopped };

/// "exit", "signal", "timeout", "memory", "stopped".
std::string_view name_of(ChildEnd end);

struct ChildDone {
  ChildEnd end = ChildEnd::kExit;
  int code = 0;  // the exit code, or the signal
  double wall_s = 0;
  std::int64_t peak_memory_bytes = 0;
};

class Child {
 public:
  /// Starts the program. It ends when this process does, however that ends. Errors: kIo.
  static Result<std::unique_ptr<Child>> start(const ChildSpec& spec);
  /// Kills it if it runs.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Holds it to its limits. Returns whether it has ended.
  bool has_ended();
  /// Asks it to end; after a few seconds it is killed. It counts as stopped.
  void stop();
  /// How it ended.
  const ChildDone& done() const { return done_; }

 private:
  using Clock = std::chrono::steady_clock;
  Child() = default;
  void end_for(ChildEnd reason);
  double seconds() const;
  std::int64_t memory_now() const;

  int pid_ = -1;
  double timeout_s_ = 0;
  std::int64_t memory_bytes_ = 0;
  Clock::time_point began_;
  Clock::time_point told_;  // to end
  bool ending_ = false;
  ChildEnd reason_ = ChildEnd::kExit;
  ChildDone done_;
};

}  // namespace pentimento
