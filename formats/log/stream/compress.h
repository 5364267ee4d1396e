#pragma once
// Compression of a stream of bytes on its way into an output file.

#include <memory>
#include <span>
#include <string_view>

#include "formats/io/output_file.h"

namespace pentimento::log {

class ByteSink {
 public:
  virtual ~ByteSink() = default;
  virtual void write(std::span<const char> bytes) = 0;
  /// Ends the stream; the file itself is the caller's to publish.
  virtual void end() = 0;
};

enum class Compression { kNone, kGzip, kZstd };

/// The compression that the end of the name asks for: .gz, .zst, else none.
Compression compression_of(std::string_view path);

/// How hard gzip looks for repeated text. kLittle is three times faster, and right for text in
/// which next to nothing repeats, such as hashes.
enum class Effort { kUsual, kLittle };

// Each sink writes into `file`, which must outlive it.
std::unique_ptr<ByteSink> gzip_sink(OutputFile& file, Effort effort);
/// With the frame's checksum.
std::unique_ptr<ByteSink> zstd_sink(OutputFile& file);
std::unique_ptr<ByteSink> open_sink(OutputFile& file, Compression compression,
                                    Effort effort = Effort::kUsual);

}  // namespace pentimento::log
