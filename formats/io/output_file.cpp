#include "formats/io/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <ctime>
#include <utility>

#include "formats/io/file_place.h"
#include "formats/io/part_file.h"
#include "formats/io/stream_write.h"
#include "formats/io/temporaries.h"

namespace pentimento {

namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 20;
constexpr int kStreamFile = STDOUT_FILENO;

/// Opens a pipe that another program reads, and waits a while until it does. Returns the
/// descriptor, or -1 and errno.
int open_pipe(const std::string& path) {
  constexpr int kLooks = 200;
  constexpr timespec kBetween = {0, 50'000'000};  // so that it waits for 10 s
  for (int look = 0; look < kLooks; ++look) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor >= 0 || errno != ENXIO) return descriptor;
    if (::nanosleep(&kBetween, nullptr) != 0) return -1;
  }
  errno = ENXIO;
  return -1;
}

/// Writes all bytes to a file; returns 0 or errno.
int write_all(int descriptor, const std::uint8_t* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t n = ::write(descriptor, bytes, count);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return errno;
    if (n == 0) return EIO;
    bytes += n;
    count -= static_cast<std::size_t>(n);
  }
  return 0;
}

}  // namespace

Error OutputFile::io_error(int error_number) const {
  const std::string name = path_ == "-" ? "standard output" : path_;
  if (error_number == EINTR) return {ErrorCode::kInterrupted, name + ": interrupted"};
  if (error_number == ENXIO) return {ErrorCode::kIo, name + ": nobody reads this pipe"};
  return {ErrorCode::kIo, fmt::format("{}: {}", name, std::strerror(error_number))};
}

Result<std::unique_ptr<OutputFile>> OutputFile::create(const std::string& path, bool no_clobber) {
  std::unique_ptr<OutputFile> file(new OutputFile);
  file->path_ = path;
  file->no_clobber_ = no_clobber;
  file->buffer_.reserve(kBufferBytes);
  if (path == "-") {
    file->descriptor_ = kStreamFile;
    return file;
  }
  const Result<void> opened = file->open_temporary(no_clobber);
  if (!opened) return opened.error();
  return file;
}

Result<void> OutputFile::open_temporary(bool no_clobber) {
  target_ = follow_links(path_);
  struct stat info = {};
  if (::stat(target_.c_str(), &info) == 0) {
    if (S_ISDIR(info.st_mode)) return io_error(EISDIR);
    if (!S_ISREG(info.st_mode)) {
      // A pipe or a device: replacing it by a file would be wrong, so bytes go through it.
      descriptor_ = S_ISFIFO(info.st_mode) ? open_pipe(target_)
                                           : ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
      return descriptor_ < 0 ? Result<void>(io_error(errno)) : Result<void>();
    }
    if (no_clobber) return io_error(EEXIST);
  }
  temporary_ = part_name(target_);
  descriptor_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor_ >= 0) {
    note_temporary(temporary_);
    return {};
  }
  const Error error = io_error(errno);
  temporary_.clear();
  return error;
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0 && descriptor_ != kStreamFile) ::close(descriptor_);
  if (temporary_.empty()) return;
  if (!published_) ::unlink(temporary_.c_str());
  forget_temporary(temporary_);
}

void OutputFile::write(const void* bytes, std::size_t count) {
  if (failed()) return;
  const auto* from = static_cast<const std::uint8_t*>(bytes);
  position_ += count;
  while (count > 0) {
    const std::size_t room = kBufferBytes - buffer_.size();
    const std::size_t n = count < room ? count : room;
    buffer_.insert(buffer_.end(), from, from + n);
    from += n;
    count -= n;
    if (buffer_.size() == kBufferBytes) flush();
  }
}

void OutputFile::flush() {
  if (!failed())
    error_number_ = is_stream() ? write_to_stream(descriptor_, buffer_.data(), buffer_.size())
                                : write_all(descriptor_, buffer_.data(), buffer_.size());
  if (sequential_) written_.update(buffer_.data(), buffer_.size());
  buffer_.clear();
}

void OutputFile::seek(std::uint64_t offset) {
  if (offset == position_) return;
  flush();
  sequential_ = false;
  position_ = offset;
  if (!failed() && ::lseek(descriptor_, static_cast<off_t>(offset), SEEK_SET) < 0)
    error_number_ = errno;
}

void OutputFile::read_at(std::uint64_t offset, void* bytes, std::size_t count) {
  flush();
  auto* to = static_cast<std::uint8_t*>(bytes);
  while (!failed() && count > 0) {
    const ssize_t n = ::pread(descriptor_, to, count, static_cast<off_t>(offset));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) error_number_ = errno;
    if (n <= 0) return;
    to += n;
    offset += static_cast<std::uint64_t>(n);
    count -= static_cast<std::size_t>(n);
  }
}

Result<void> OutputFile::status() const {
  if (failed()) return io_error(error_number_);
  return {};
}

Result<std::string> OutputFile::read_back() const {
  // Drop the cached pages, so that what is read is what the disk has.
  static_cast<void>(::posix_fadvise(descriptor_, 0, 0, POSIX_FADV_DONTNEED));
  if (::lseek(descriptor_, 0, SEEK_SET) < 0) return io_error(errno);
  Sha256 hash;
  std::vector<std::uint8_t> bytes(kBufferBytes);
  for (;;) {
    const ssize_t n = ::read(descriptor_, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return io_error(errno);
    if (n == 0) return hash.hex();
    hash.update(bytes.data(), static_cast<std::size_t>(n));
  }
}

Result<void> OutputFile::rename_to_target() {
  if (no_clobber_) {
    // link() fails where the name has appeared meanwhile; rename() would replace it.
    if (::link(temporary_.c_str(), target_.c_str()) != 0) return io_error(errno);
    static_cast<void>(::unlink(temporary_.c_str()));
  } else if (::rename(temporary_.c_str(), target_.c_str()) != 0) {
    return io_error(errno);
  }
  published_ = true;
  const int folder = ::open(folder_of(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return io_error(errno);
  const int synced = ::fsync(folder) == 0 ? 0 : errno;
  ::close(folder);
  // Some file systems cannot sync a folder; the file itself is safe by then.
  if (synced != 0 && synced != EINVAL) return io_error(synced);
  return {};
}

Result<Published> OutputFile::complete(const Check& check) {
  flush();
  if (failed()) return io_error(error_number_);
  if (is_stream()) {
    complete_sha256_ = written_.hex();
    return whole();
  }
  // A failed fsync is final: the kernel may have dropped the pages, a second call would succeed.
  if (::fsync(descriptor_) != 0) return io_error(errno);
  const Result<std::string> hash = read_back();
  if (!hash) return hash.error();
  if (sequential_ && *hash != written_.hex())
    return Error{ErrorCode::kIo, path_ + ": what was read back differs from what was written"};
  if (check) {
    const Result<void> checked = check(temporary_);
    if (!checked) return checked.error();
  }
  complete_sha256_ = *hash;
  // Many files may wait for their names at once; open ones are limited.
  ::close(std::exchange(descriptor_, -1));
  return whole();
}

Result<Published> OutputFile::publish(const Check& check) {
  if (complete_sha256_.empty()) {
    if (const Result<Published> whole = complete(check); !whole) return whole.error();
  }
  if (!is_stream()) {
    if (const Result<void> renamed = rename_to_target(); !renamed) return renamed.error();
  }
  return Published{path_, complete_sha256_};
}

}  // namespace pentimento
