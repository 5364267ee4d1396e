#pragma once
// Deflate (RFC 1951) by zlib, for pieces that several threads compress at once. The output of zlib
// depends on the bytes given and on nothing else, so equal pictures and states give equal files.
// (ISA-L was twice as fast, but its output differed between processors and, rarely, between runs on
// the same processor.)

#include <cstdint>
#include <span>
#include <vector>

namespace pentimento {

/// Which repeats the compressor looks for. Filtered rows of a painting are noise with runs of equal
/// bytes; other matches cost more bits than they save, and time (docs/bench/encoding.md).
enum class Repeats { kAny, kRuns };

/// Raw deflate of `bytes`, appended to `out`. `last` = false ends on a byte boundary with an empty
/// stored block, so that pieces can be joined; `last` = true ends the stream.
void deflate_piece(std::span<const std::uint8_t> bytes, bool last, int level, Repeats repeats,
                   std::vector<std::uint8_t>& out);

/// A whole zlib stream (RFC 1950) of `bytes`.
std::vector<std::uint8_t> zlib_stream(std::span<const std::uint8_t> bytes, int level);

/// Adler-32 of `bytes`; and of two joined pieces, the second `second_bytes` long.
std::uint32_t adler32_of(std::span<const std::uint8_t> bytes);
std::uint32_t adler32_joined(std::uint32_t first, std::uint32_t second, std::size_t second_bytes);

/// CRC-32 of PNG and gzip, continued from `before` (0 at the start).
std::uint32_t crc32_of(std::uint32_t before, std::span<const std::uint8_t> bytes);

}  // namespace pentimento
