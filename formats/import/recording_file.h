#pragma once
// The content of a file that another program recorded.

#include <cstdint>
#include <string>

#include "core/base/result.h"
#include "formats/log/stream/byte_source.h"

namespace pentimento::sketch {

/// What a recording may hold at most, unpacked. As a table that is two million samples, over four
/// hours of painting without a pause. Readers hold all samples, so this bounds memory, too
/// (docs/bench/convert.md).
constexpr std::int64_t kMostRecordingBytes = std::int64_t{64} << 20;

/// The bytes of a file, unpacked if it is packed by gzip or zstd; "-" is standard input. Pipes are
/// read as they are.
/// Errors: kIo, kLimit, kBadInput (packed bytes are damaged).
Result<std::string> read_recording(const std::string& path);
/// The same of a source that was opened before, from where it stands. Messages name `path`.
Result<std::string> read_recording(const std::string& path, log::ByteSource& source);

}  // namespace pentimento::sketch
