#include "formats/log/stream/line_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "core/base/interruption.h"
#include "formats/log/json/json_line.h"

namespace pentimento::log {

namespace {
constexpr std::size_t kBlock = 1 << 18;  // bytes read at once: large enough to hide the calls
}

LineSource::LineSource(std::unique_ptr<ByteSource> source, const ReaderOptions& options)
    : source_(std::move(source)),
      limits_(options.limits),
      cancelled_(options.cancelled),
      buffer_(kBlock + JsonLine::kPadding) {}

Error LineSource::over_limit(const char* what, std::int64_t Limits::*limit) const {
  return {ErrorCode::kLimit,
          fmt::format("more than {} {}{}", limits_.*limit, what, limit_note(limit))};
}

/// Reads one more block behind what is there; false at the end.
Result<bool> LineSource::fill() {
  if (at_end_) return false;
  if (sha256_.empty()) {
    if (Result<void> go = unless_interrupted(cancelled_); !go) return go.error();
  }
  if (begin_ > 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
  }
  if (buffer_.size() < end_ + kBlock / 2 + JsonLine::kPadding) buffer_.resize(2 * buffer_.size());
  const std::size_t room = buffer_.size() - JsonLine::kPadding - end_;
  const Result<std::size_t> count = source_->read(std::span(buffer_).subspan(end_, room));
  if (!count) return count.error();
  if (sha256_.empty()) hash_.update(buffer_.data() + end_, *count);
  end_ += *count;
  bytes_ += static_cast<std::int64_t>(*count);
  if (bytes_ > limits_.max_bytes) return over_limit("bytes", &Limits::max_bytes);
  at_end_ = *count == 0;
  if (at_end_ && sha256_.empty()) sha256_ = hash_.hex();
  return !at_end_;
}

Result<std::optional<Line>> LineSource::next_line() {
  std::size_t searched = 0;
  for (;;) {
    const char* first = buffer_.data() + begin_;
    const std::size_t count = end_ - begin_;
    const void* feed = std::memchr(first + searched, '\n', count - searched);
    const std::size_t length =
        feed != nullptr ? static_cast<std::size_t>(static_cast<const char*>(feed) - first) : count;
    if (length > static_cast<std::size_t>(limits_.max_line_bytes)) {
      ++line_number_;
      return Error{ErrorCode::kLimit,
                   fmt::format("the line is longer than {} bytes{}", limits_.max_line_bytes,
                               limit_note(&Limits::max_line_bytes))};
    }
    if (feed != nullptr) {
      begin_ += length + 1;
      return std::optional(Line{{first, length}, ++line_number_, true});
    }
    searched = count;
    const Result<bool> more = fill();
    if (!more) {
      ++line_number_;
      return more.error();
    }
    if (!*more) break;
  }
  if (begin_ == end_) return std::optional<Line>();
  const Line last = {{buffer_.data() + begin_, end_ - begin_}, ++line_number_, false};
  begin_ = end_;
  return std::optional(last);
}

Result<std::optional<Line>> LineSource::next() {
  for (;;) {
    Result<std::optional<Line>> line = next_line();
    if (!line || !*line) return line;
    if ((*line)->text.find_first_not_of(" \t\r") != std::string_view::npos) return line;
    if (++blank_lines_ > limits_.max_events) return over_limit("blank lines", &Limits::max_events);
  }
}

Result<void> LineSource::rewind() {
  begin_ = end_ = 0;
  line_number_ = 0;
  at_end_ = false;
  bytes_ = blank_lines_ = 0;
  if (sha256_.empty()) hash_ = Sha256();
  return source_->rewind();
}

}  // namespace pentimento::log
