#include "formats/log/stream/raw_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <vector>

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

Result<std::unique_ptr<RawFile>> RawFile::open(const std::string& path) {
  const bool standard_input = path == "-";
  const std::string name = standard_input ? "standard input" : path;
  const int descriptor =
      standard_input ? ::dup(STDIN_FILENO) : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return io_error(name, "cannot be opened");
  std::unique_ptr<RawFile> file(new RawFile(descriptor, name));
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) return io_error(name, "cannot be opened");
  if (S_ISDIR(status.st_mode)) {
    errno = EISDIR;
    return io_error(name, "cannot be read");
  }
  // Standard input may be a file that another program has read in part, so it is copied.
  if (standard_input || !S_ISREG(status.st_mode)) {
    const Result<void> spooled = file->spool();
    if (!spooled) return spooled.error();
  }
  return file;
}

RawFile::~RawFile() {
  ::close(descriptor_);
}

Result<void> RawFile::spool() {
  const int copy = open_unlinked();
  if (copy < 0) return io_error(name_, "no temporary file to keep it in");
  std::vector<char> buffer(1 << 18);
  for (;;) {
    const Result<std::size_t> count = read(buffer);
    const bool written = count && write_all(copy, std::span(buffer).first(*count));
    if (!count || !written) {
      const Error error =
          count ? io_error(name_, "its temporary copy cannot be written") : count.error();
      ::close(copy);
      return error;
    }
    if (*count == 0) break;
  }
  ::close(descriptor_);
  descriptor_ = copy;
  return rewind();
}

Result<std::size_t> RawFile::read(std::span<char> bytes) {
  std::size_t filled = 0;
  while (filled < bytes.size()) {
    const ssize_t count = ::read(descriptor_, bytes.data() + filled, bytes.size() - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return io_error(name_, "cannot be read");
    if (count == 0) break;
    filled += static_cast<std::size_t>(count);
  }
  return filled;
}

Result<void> RawFile::rewind() {
  if (::lseek(descriptor_, 0, SEEK_SET) != 0) return io_error(name_, "cannot be read again");
  return {};
}

}  // namespace pentimento::log
