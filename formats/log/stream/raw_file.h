#pragma once
// A file opened for reading, as stored; the lowest layer of ByteSource.

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "core/base/result.h"

namespace pentimento::log {

class RawFile {
 public:
  /// See ByteSource::open().
  static Result<std::unique_ptr<RawFile>> open(const std::string& path);
  ~RawFile();
  RawFile(const RawFile&) = delete;
  RawFile& operator=(const RawFile&) = delete;

  /// Fills `bytes` unless the file ends; 0 at the end. Errors: kIo.
  Result<std::size_t> read(std::span<char> bytes);
  Result<void> rewind();

 private:
  RawFile(int descriptor, std::string name) : descriptor_(descriptor), name_(std::move(name)) {}
  Result<void> spool();
  int descriptor_;
  std::string name_;
};

}  // namespace pentimento::log
