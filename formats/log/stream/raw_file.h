#pragma once
// A file opened for reading, as stored; the lowest layer of ByteSource. What cannot be read twice
// (a pipe) is copied into a temporary file while it is read for the first time, so that no more of
// it is copied than somebody wants to read.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "core/base/result.h"
#include "formats/log/tables/reader_options.h"

namespace pentimento::log {

class RawFile {
 public:
  /// See ByteSource::open().
  static Result<std::unique_ptr<RawFile>> open(const std::string& path,
                                               const ReaderOptions& options = {});
  ~RawFile();
  RawFile(const RawFile&) = delete;
  RawFile& operator=(const RawFile&) = delete;

  /// Fills `bytes` unless the file ends; 0 at the end. Errors: kIo; kLimit for a pipe that does not
  /// end; kInterrupted.
  Result<std::size_t> read(std::span<char> bytes);
  Result<void> rewind();

 private:
  RawFile(int descriptor, std::string name, const ReaderOptions& options)
      : descriptor_(descriptor),
        name_(std::move(name)),
        cancelled_(options.cancelled),
        most_bytes_(options.limits.max_bytes) {}
  Result<void> begin_copy();
  /// What is there of the file itself, at least a byte unless it ends.
  Result<std::size_t> read_some(std::span<char> bytes);
  Result<std::size_t> read_pipe(std::span<char> bytes);
  Result<std::size_t> read_copy(std::span<char> bytes);

  int descriptor_;
  std::string name_;
  const std::atomic<bool>* cancelled_;
  std::int64_t most_bytes_;    // that are copied
  int copy_ = -1;              // of a pipe; else -1
  std::int64_t copied_ = 0;    // bytes of the pipe
  std::int64_t position_ = 0;  // in the copy
  bool pipe_has_ended_ = false;
};

}  // namespace pentimento::log
