#include "formats/io/stream_write.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>

namespace pentimento {

namespace {
/// A pipe that has room has room for that much, so a write of it does not wait. One that waits and
/// had written a part would end with the part at a signal, and not say that a signal came.
constexpr std::size_t kPiece_bytes = PIPE_BUF;
}  // namespace

int write_to_stream(int descriptor, const void* bytes, std::size_t count) {
  const char* next = static_cast<const char*>(bytes);
  while (count > 0) {
    pollfd room{descriptor, POLLOUT, 0};
    if (::poll(&room, 1, -1) < 0) return errno;
    const ssize_t n = ::write(descriptor, next, std::min(count, kPiece_bytes));
    if (n < 0 && errno == EAGAIN) continue;
    if (n < 0) return errno;
    if (n == 0) return EIO;
    next += n;
    count -= static_cast<std::size_t>(n);
  }
  return 0;
}

}  // namespace pentimento
