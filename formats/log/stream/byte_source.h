#pragma once
// The decompressed bytes of a file or of standard input, in order and again from the start. Plain,
// gzip (also several members) or zstd (also several frames), recognised by content.

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "core/base/result.h"
#include "formats/log/tables/reader_options.h"

namespace pentimento::log {

class ByteSource {
 public:
  /// "-" is standard input; what cannot be rewound (pipes) is copied to an unlinked temporary file
  /// in $TMPDIR or /tmp while it is read first. Of the options, `cancelled` and the limit of bytes
  /// count. Errors: kIo, kInterrupted; kLimit, without the file's name.
  static Result<std::unique_ptr<ByteSource>> open(const std::string& path,
                                                  const ReaderOptions& options = {});
  virtual ~ByteSource() = default;

  /// Fills `bytes` from its start; fewer than asked for only near the end, 0 at the end.
  /// Errors: kIo; kBadInput where compressed data are damaged.
  virtual Result<std::size_t> read(std::span<char> bytes) = 0;
  virtual Result<void> rewind() = 0;
  /// After read() gave 0: the compressed data ended too early.
  virtual bool cut_short() const { return false; }
};

}  // namespace pentimento::log
