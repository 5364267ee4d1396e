#pragma once
// What zlib is told about a stream of gzip. For the .cpp files of this folder only.

namespace pentimento::log {

/// The largest window; +16: with gzip's header and checksum.
inline constexpr int kGzipWindow = 15 + 16;

}  // namespace pentimento::log
