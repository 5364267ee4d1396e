#pragma once

#include <cstddef>

namespace pentimento {

/// Writes all bytes to standard output, a pipe, a terminal or a device. Who reads there may never
/// go on reading, so a signal that the process listens to ends the wait. Returns 0 or errno, EINTR
/// for such a signal.
int write_to_stream(int descriptor, const void* bytes, std::size_t count);

}  // namespace pentimento
