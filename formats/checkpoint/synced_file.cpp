#include "formats/checkpoint/synced_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>
#include <vector>

namespace pentimento::checkpoint {

namespace {
Error io_error(const std::string& path, int error_number) {
  return {ErrorCode::kIo, path + ": " + std::strerror(error_number)};
}

std::uint64_t size_of(int descriptor) {
  struct stat info = {};
  return ::fstat(descriptor, &info) == 0 ? static_cast<std::uint64_t>(info.st_size) : 0;
}

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}
}  // namespace

SyncedFile::SyncedFile(std::string path, int descriptor, std::uint64_t size)
    : path_(std::move(path)), descriptor_(descriptor), size_(size) {}

SyncedFile::~SyncedFile() {
  ::close(descriptor_);
}

Result<std::unique_ptr<SyncedFile>> SyncedFile::create(const std::string& path) {
  ::unlink(path.c_str());  // never through a link or into a pipe of that name
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) return io_error(path, errno);
  return std::unique_ptr<SyncedFile>(new SyncedFile(path, descriptor, 0));
}

Result<std::unique_ptr<SyncedFile>> SyncedFile::go_on(const std::string& path, std::uint64_t size) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) return io_error(path, errno);
  std::unique_ptr<SyncedFile> file(new SyncedFile(path, descriptor, size));
  if (size_of(descriptor) < size) return Error{ErrorCode::kBadInput, path + ": it ends too early"};
  const auto end = static_cast<off_t>(size);
  if (::ftruncate(descriptor, end) != 0 || ::lseek(descriptor, end, SEEK_SET) != end)
    return io_error(path, errno);
  return file;
}

void SyncedFile::write(std::string_view bytes) {
  size_ += bytes.size();
  while (error_number_ == 0 && !bytes.empty()) {
    const ssize_t n = ::write(descriptor_, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      error_number_ = n < 0 ? errno : EIO;
      return;
    }
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
}

Result<void> SyncedFile::sync() {
  // A failed fsync is final: the kernel may have dropped the pages, a second call would succeed.
  if (error_number_ == 0 && ::fsync(descriptor_) != 0) error_number_ = errno;
  if (error_number_ != 0) return io_error(path_, error_number_);
  return {};
}

PlacedReader::PlacedReader(std::string path, int descriptor, std::uint64_t size)
    : path_(std::move(path)), descriptor_(descriptor), size_(size) {}

PlacedReader::~PlacedReader() {
  ::close(descriptor_);
}

Result<std::unique_ptr<PlacedReader>> PlacedReader::open(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return io_error(path, errno);
  std::unique_ptr<PlacedReader> file(new PlacedReader(path, descriptor, size_of(descriptor)));
  struct stat info = {};
  if (::fstat(descriptor, &info) == 0 && S_ISREG(info.st_mode)) return file;
  return Error{ErrorCode::kBadInput, path + ": it is no file"};
}

Result<void> PlacedReader::read(std::uint64_t offset, std::span<char> out) const {
  if (offset > size_ || out.size() > size_ - offset)
    return Error{ErrorCode::kBadInput, path_ + ": it ends too early"};
  while (!out.empty()) {
    const ssize_t n = ::pread(descriptor_, out.data(), out.size(), static_cast<off_t>(offset));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return io_error(path_, errno);
    if (n == 0) return Error{ErrorCode::kBadInput, path_ + ": it ends too early"};
    out = out.subspan(static_cast<std::size_t>(n));
    offset += static_cast<std::uint64_t>(n);
  }
  return {};
}

Result<void> sync_folder(const std::string& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return io_error(folder, errno);
  const int problem = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  // Some file systems cannot sync a folder.
  if (problem != 0 && problem != EINVAL) return io_error(folder, problem);
  return {};
}

Result<void> rename_synced(const std::string& from, const std::string& to) {
  if (::rename(from.c_str(), to.c_str()) != 0) return io_error(to, errno);
  return sync_folder(folder_of(to));
}

Result<void> link_or_copy(const std::string& from, const std::string& to) {
  ::unlink(to.c_str());
  if (::link(from.c_str(), to.c_str()) == 0) return {};
  Result<std::unique_ptr<PlacedReader>> source = PlacedReader::open(from);
  if (!source) return source.error();
  Result<std::unique_ptr<SyncedFile>> copy = SyncedFile::create(to);
  if (!copy) return copy.error();
  std::vector<char> bytes(std::size_t{1} << 20);
  for (std::uint64_t done = 0; done < (*source)->size(); done += bytes.size()) {
    bytes.resize(
        static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), (*source)->size() - done)));
    if (Result<void> read = (*source)->read(done, bytes); !read) return read;
    (*copy)->write({bytes.data(), bytes.size()});
  }
  return (*copy)->sync();
}

}  // namespace pentimento::checkpoint
