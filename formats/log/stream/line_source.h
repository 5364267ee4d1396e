#pragma once
// The lines of a log, one at a time, from a buffer that grows only with the longest line.

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "formats/io/sha256.h"
#include "formats/log/stream/byte_source.h"

namespace pentimento::log {

struct Line {
  std::string_view text;    // without its line feed; JsonLine::kPadding bytes are readable after it
  std::int64_t number = 0;  // from 1
  bool ended = true;        // by a line feed
};

class LineSource {
 public:
  /// Of the options, the limits of bytes, lines and blank lines count, and `cancelled`, which is
  /// heard until the end is reached first: from then on the length is known.
  LineSource(std::unique_ptr<ByteSource> source, const ReaderOptions& options);

  /// The next line that is not blank, or nothing at the end; it holds until the next call.
  /// Errors, without the file's name: kLimit for a line too long, too many bytes, too many blank
  /// lines; kInterrupted; those of ByteSource.
  Result<std::optional<Line>> next();
  Result<void> rewind();

  /// Of the last line, or of the one that failed.
  std::int64_t line_number() const { return line_number_; }
  /// After the end: the compressed data ended too early.
  bool cut_short() const { return source_->cut_short(); }
  /// SHA-256 of all bytes; empty before the end was once reached.
  const std::string& sha256() const { return sha256_; }

 private:
  Error over_limit(const char* what, std::int64_t Limits::*limit) const;
  Result<bool> fill();
  Result<std::optional<Line>> next_line();

  std::unique_ptr<ByteSource> source_;
  const Limits limits_;
  const std::atomic<bool>* const cancelled_;
  std::int64_t bytes_ = 0, blank_lines_ = 0;  // so far
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;  // of what is read and not yet given out
  std::int64_t line_number_ = 0;
  bool at_end_ = false;
  Sha256 hash_;
  std::string sha256_;
};

}  // namespace pentimento::log
