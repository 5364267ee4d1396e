#pragma once
// Reads an action log as a stream: header first, then one event at a time; memory does not grow
// with the log. Plain, gzip or zstd by content; "-" is standard input, spooled to a temporary file
// so that rewind() works. Checks all that docs/action-log.md forbids; errors are
// "file:line: field value limit" with kBadInput, limits kLimit.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "formats/log/tables/events.h"

namespace pentimento::log {

/// Adjustable bounds against hostile or broken input.
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
  bool allow_outside = false;  // files may be named by absolute paths or through `..`
};

class Reader {
 public:
  static Result<std::unique_ptr<Reader>> open(const std::string& path,
                                              const ReaderOptions& options);
  virtual ~Reader() = default;
  virtual const Header& header() const = 0;
  /// The next event, or nothing at the end.
  virtual Result<std::optional<Event>> next() = 0;
  /// Back to the first event.
  virtual Result<void> rewind() = 0;
  /// SHA-256 (hex) of the log's decompressed bytes; known once next() has returned the end.
  virtual std::string sha256() const = 0;
  /// What salvage dropped: "line 812 is cut short (37 bytes dropped)"; empty if nothing.
  virtual std::string salvaged() const = 0;
};

}  // namespace pentimento::log
