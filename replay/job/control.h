#pragma once
// How a long job reports its progress, and how it is told to stop. The functions of the caller run
// on the caller's thread.

#include <atomic>
#include <cstdint>
#include <functional>
#include <string_view>

#include "core/base/interruption.h"
#include "core/base/result.h"

namespace pentimento {

struct ProgressState {
  std::string_view phase;  // "read", "survey", "simulate", "shade", "encode"
  std::int64_t done = 0;
  std::int64_t total = 0;  // 0: not known
};

struct Control {
  std::function<void(const ProgressState&)> progress;  // may be empty
  std::function<void(const std::string&)> warn;        // may be empty
  const std::atomic<bool>* cancelled = nullptr;        // set from a signal handler

  void report(const ProgressState& state) const {
    if (progress) progress(state);
  }
  void warning(const std::string& text) const {
    if (warn) warn(text);
  }
  /// Ok, or kInterrupted once `cancelled` is set.
  Result<void> go_on() const { return unless_interrupted(cancelled); }
};

}  // namespace pentimento
