#pragma once
// Compression of a stream of bytes on its way into an output file.

#include <memory>
#include <span>

#include "formats/io/output_file.h"

namespace pentimento::log {

class ByteSink {
 public:
  virtual ~ByteSink() = default;
  virtual void write(std::span<const char> bytes) = 0;
  /// Ends the stream; the file itself is the caller's to publish.
  virtual void end() = 0;
};

// Each sink writes into `file`, which must outlive it.
std::unique_ptr<ByteSink> gzip_sink(OutputFile& file);
/// With the frame's checksum.
std::unique_ptr<ByteSink> zstd_sink(OutputFile& file);

}  // namespace pentimento::log
