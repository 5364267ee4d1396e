#pragma once
// A file that appears under its name only when it is whole. It is written beside the target under a
// temporary name, checked, forced to the disk, read back, and then renamed to the target. If
// anything fails, the target keeps its old content and the temporary file is removed. Not
// thread-safe.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "formats/io/picture_file.h"
#include "formats/io/sha256.h"

namespace pentimento {

class OutputFile {
 public:
  /// Checks a file under its temporary name before it is published.
  using Check = std::function<Result<void>(const std::string& temporary)>;

  /// "-" is standard output; pipes and devices are written to directly (no temporary, no renaming).
  /// A link is followed. Errors: kIo (a directory, no parent, not writable, exists and
  /// `no_clobber`).
  static Result<std::unique_ptr<OutputFile>> create(const std::string& path, bool no_clobber);
  /// Removes the temporary if publish() has not succeeded.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Writes at the position. The first failure stays: later writes do nothing, and publish()
  /// returns it.
  void write(const void* bytes, std::size_t count);
  /// Later writes go to `offset`. Not for streams.
  void seek(std::uint64_t offset);
  /// Reads what was written at `offset`. Beyond the end, and after a failure, `bytes` stay as they
  /// are. Not for streams.
  void read_at(std::uint64_t offset, void* bytes, std::size_t count);
  std::uint64_t position() const { return position_; }
  bool failed() const { return error_number_ != 0; }
  /// Ok, or the first failure.
  Result<void> status() const;
  /// Standard output, a pipe or a device: neither seeks nor can be read back.
  bool is_stream() const { return temporary_.empty(); }

  /// Makes the file whole under its temporary name. Then `check` must find it right, and without a
  /// seek() the bytes read back must have the SHA-256 of the bytes written. Errors: kIo, that of
  /// `check`. Call once.
  Result<Published> complete(const Check& check = {});
  /// What complete() returned; the hash is empty before.
  Published whole() const { return {path_, complete_sha256_, temporary_}; }
  /// Gives the file its name, after complete() if that was not called. Call once.
  Result<Published> publish(const Check& check = {});

 private:
  OutputFile() = default;
  Result<void> open_temporary(bool no_clobber);
  void flush();
  Result<std::string> read_back() const;
  Result<void> rename_to_target();
  Error io_error(int error_number) const;

  std::string path_;       // as the user gave it
  std::string target_;     // links resolved
  std::string temporary_;  // empty for streams
  int descriptor_ = -1;
  int error_number_ = 0;  // errno of the first failure
  bool no_clobber_ = false;
  bool published_ = false;
  std::string complete_sha256_;  // set by complete()
  bool sequential_ = true;       // no seek() so far: `written_` is the file's hash
  Sha256 written_;
  std::uint64_t position_ = 0;
  std::vector<std::uint8_t> buffer_;
};

}  // namespace pentimento
