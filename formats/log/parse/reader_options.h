#pragma once
// The options of reading a log.

#include <cstdint>

namespace pentimento::log {

/// Bounds against hostile or broken input.
struct Limits {
  std::int64_t max_events = 200'000'000;
  std::int64_t max_line_bytes = 16 << 20;
  std::int64_t max_steps = 100'000'000;
  int max_depth = 16;      // of nesting; exceeding it is kBadInput, no event nests so deep
  int max_touches = 64;    // down at once
  int max_colors = 65536;  // different `color` values
};

struct ReaderOptions {
  Limits limits;
  bool salvage = false;  // a log cut short in its last line: stop before it instead of failing
  bool repair = false;   // put right or drop what a log may not have; the header must be right
  bool allow_outside = false;  // files may be named by absolute paths or through `..`
};

}  // namespace pentimento::log
