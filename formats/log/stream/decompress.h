#pragma once
// Decompression as a ByteSource over a RawFile.

#include <memory>

#include "formats/log/stream/byte_source.h"
#include "formats/log/stream/raw_file.h"

namespace pentimento::log {

/// RFC 1952, one or several members.
std::unique_ptr<ByteSource> open_gzip(std::unique_ptr<RawFile> file);
/// RFC 8878, one or several frames; windows up to 128 MiB.
std::unique_ptr<ByteSource> open_zstd(std::unique_ptr<RawFile> file);

}  // namespace pentimento::log
