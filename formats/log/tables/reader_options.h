#pragma once
// The options of reading a log.

#include <atomic>

#include "formats/log/tables/limits.h"

namespace pentimento::log {

struct ReaderOptions {
  Limits limits;
  bool salvage = false;  // a log cut short in its last line: stop before it instead of failing
  bool repair = false;   // put right or drop what a log may not have; the header must be right
  bool allow_outside = false;  // files may be named by absolute paths or through `..`
  /// Set from a signal handler; ends the reading, also the wait for what a pipe has not sent yet.
  /// May be null.
  const std::atomic<bool>* cancelled = nullptr;
};

}  // namespace pentimento::log
