#include "formats/log/stream/raw_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "core/base/interruption.h"

namespace pentimento::log {

namespace {

Error io_error(const std::string& name, const char* what) {
  return {ErrorCode::kIo, fmt::format("{}: {}: {}", name, what, std::strerror(errno))};
}

/// A temporary file without a name, or -1 and errno.
int open_unlinked() {
  const char* folder = std::getenv("TMPDIR");
  std::string path = folder != nullptr && *folder != '\0' ? folder : "/tmp";
  path += "/pentimento-XXXXXX";
  const int descriptor = ::mkostemp(path.data(), O_CLOEXEC);
  if (descriptor >= 0) ::unlink(path.c_str());
  return descriptor;
}

/// Waits until the descriptor has bytes or has ended. Errors: kInterrupted.
Result<void> wait_for_bytes(int descriptor, const std::atomic<bool>* cancelled) {
  constexpr int kLook_ms = 100;  // a signal that comes just before poll() does not end it
  pollfd waiting{descriptor, POLLIN, 0};
  do {
    if (Result<void> go = unless_interrupted(cancelled); !go) return go;
  } while (::poll(&waiting, 1, kLook_ms) <= 0);
  return {};
}

bool write_all(int descriptor, std::span<const char> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

}  // namespace

Result<std::unique_ptr<RawFile>> RawFile::open(const std::string& path,
                                               const ReaderOptions& options) {
  const bool standard_input = path == "-";
  const std::string name = standard_input ? "standard input" : path;
  // O_NONBLOCK: a pipe that nobody writes to yet is waited for later, where signals are heard.
  const int descriptor = standard_input ? ::dup(STDIN_FILENO)
                                        : ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return io_error(name, "cannot be opened");
  std::unique_ptr<RawFile> file(new RawFile(descriptor, name, options));
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) return io_error(name, "cannot be opened");
  if (S_ISDIR(status.st_mode)) {
    errno = EISDIR;
    return io_error(name, "cannot be read");
  }
  // Standard input may be a file that another program has read in part, so it is copied.
  if (standard_input || !S_ISREG(status.st_mode)) {
    if (const Result<void> begun = file->begin_copy(); !begun) return begun.error();
  }
  return file;
}

RawFile::~RawFile() {
  ::close(descriptor_);
  if (copy_ >= 0) ::close(copy_);
}

Result<void> RawFile::begin_copy() {
  copy_ = open_unlinked();
  if (copy_ < 0) return io_error(name_, "no temporary file to keep it in");
  return {};
}

Result<std::size_t> RawFile::read_some(std::span<char> bytes) {
  for (;;) {
    const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno != EINTR && errno != EAGAIN) return io_error(name_, "cannot be read");
    if (const Result<void> waited = wait_for_bytes(descriptor_, cancelled_); !waited)
      return waited.error();
  }
}

/// The next bytes of the pipe, which are then in the copy, too.
Result<std::size_t> RawFile::read_pipe(std::span<char> bytes) {
  if (pipe_has_ended_) return std::size_t{0};
  if (const Result<void> waited = wait_for_bytes(descriptor_, cancelled_); !waited)
    return waited.error();
  const Result<std::size_t> count = read_some(bytes);
  if (!count) return count;
  pipe_has_ended_ = *count == 0;
  copied_ += static_cast<std::int64_t>(*count);
  if (copied_ > most_bytes_) {
    return Error{ErrorCode::kLimit,
                 fmt::format("more than {} bytes{}", most_bytes_, limit_note(&Limits::max_bytes))};
  }
  if (!write_all(copy_, bytes.first(*count)))
    return io_error(name_, "its temporary copy cannot be written");
  position_ = copied_;
  return count;
}

Result<std::size_t> RawFile::read_copy(std::span<char> bytes) {
  if (position_ == copied_) return read_pipe(bytes);
  const auto left = static_cast<std::size_t>(copied_ - position_);
  const ssize_t count =
      ::pread(copy_, bytes.data(), std::min(bytes.size(), left), static_cast<off_t>(position_));
  if (count < 0 && errno == EINTR) return read_copy(bytes);
  if (count <= 0) return io_error(name_, "its temporary copy cannot be read");
  position_ += count;
  return static_cast<std::size_t>(count);
}

Result<std::size_t> RawFile::read(std::span<char> bytes) {
  std::size_t filled = 0;
  while (filled < bytes.size()) {
    const std::span<char> rest = bytes.subspan(filled);
    const Result<std::size_t> count = copy_ < 0 ? read_some(rest) : read_copy(rest);
    if (!count) return count.error();
    if (*count == 0) break;
    filled += *count;
  }
  return filled;
}

Result<void> RawFile::rewind() {
  position_ = 0;
  if (copy_ < 0 && ::lseek(descriptor_, 0, SEEK_SET) != 0)
    return io_error(name_, "cannot be read again");
  return {};
}

}  // namespace pentimento::log
