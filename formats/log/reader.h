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
#include <vector>

#include "core/base/result.h"
#include "formats/log/stream/byte_source.h"
#include "formats/log/tables/events.h"
#include "formats/log/tables/reader_options.h"

namespace pentimento::log {

class Reader {
 public:
  static Result<std::unique_ptr<Reader>> open(const std::string& path,
                                              const ReaderOptions& options);
  /// The same of a source that was opened before and is at its start; `path` names it in messages.
  static Result<std::unique_ptr<Reader>> open(const std::string& path,
                                              std::unique_ptr<ByteSource> source,
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
  /// What repair did, a few words each; empty if nothing.
  virtual std::vector<std::string> repaired() const { return {}; }
};

}  // namespace pentimento::log
