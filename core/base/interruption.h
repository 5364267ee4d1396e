#pragma once
// How long work hears that it shall stop: a flag that a signal handler sets.

#include <atomic>

#include "core/base/result.h"

namespace pentimento {

/// Ok, or kInterrupted once `cancelled` is set. nullptr: nobody interrupts.
inline Result<void> unless_interrupted(const std::atomic<bool>* cancelled) {
  if (cancelled == nullptr || !cancelled->load(std::memory_order_relaxed)) return {};
  return Error{ErrorCode::kInterrupted, "interrupted; nothing was written"};
}

}  // namespace pentimento
