#pragma once
// What is checked of an OpenEXR file before its pixels are read. The C++ library believes the
// lengths that a file names, and asks for that much memory; its C core compares most of them with
// the length of the file first, and what it leaves out is compared here.

#include <cstdint>
#include <string>

#include "core/base/result.h"

namespace pentimento::exr {

/// Channels of a picture, at most. One of ours has a channel for each pigment of its log, 4096 at
/// most unless that limit is raised, and below 64 others.
inline constexpr int kMostChannels = 4096 + 64;

/// Bytes of rows that are packed together, unpacked, at most: 16 rows of 65536 values of 64
/// channels of 32 bits.
inline constexpr std::uint64_t kMostChunkBytes = std::uint64_t{1} << 28;

/// Parses the headers of the file at `path`. Errors: kBadInput if they are damaged or name more
/// chunks than the file can hold, kLimit for more than kMostChannels channels or kMostChunkBytes.
Result<void> check_header(const std::string& path);

}  // namespace pentimento::exr
