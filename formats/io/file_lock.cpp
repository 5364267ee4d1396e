#include "formats/io/file_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "formats/io/file_place.h"
#include "formats/io/part_file.h"
#include "formats/io/sha256.h"
#include "formats/io/temporaries.h"

namespace pentimento {

namespace {
constexpr std::string_view kLockPrefix = ".pentimento-";
constexpr std::string_view kLockSuffix = ".lock";
constexpr std::size_t kNameDigits = 16;  // of the hash: 64 bits tell the names of a folder apart

std::string lock_name(const std::string& target) {
  const std::string name = std::filesystem::path(target).filename().string();
  Sha256 hash;
  hash.update(name.data(), name.size());
  return fmt::format("{}/{}{}{}", folder_of(target), kLockPrefix, hash.hex().substr(0, kNameDigits),
                     kLockSuffix);
}

/// Its owner may have removed the file between our opening and our locking it.
bool is_still_named(const std::string& path, int descriptor) {
  struct stat named = {}, opened = {};
  return ::stat(path.c_str(), &named) == 0 && ::fstat(descriptor, &opened) == 0 &&
         named.st_dev == opened.st_dev && named.st_ino == opened.st_ino;
}

Error failed(const std::string& target, int error_number) {
  return {ErrorCode::kIo, fmt::format("{}: {}", target, std::strerror(error_number))};
}
}  // namespace

Result<std::unique_ptr<FileLock>> FileLock::take(const std::string& target) {
  const std::string path = lock_name(follow_links(target));
  for (;;) {
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor < 0) return failed(target, errno);
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
      const int error_number = errno;
      ::close(descriptor);
      if (error_number == EINTR) continue;
      if (error_number == ENOLCK || error_number == EOPNOTSUPP) return {nullptr};
      if (error_number != EWOULDBLOCK) return failed(target, error_number);
      return Error{ErrorCode::kUsage, fmt::format("-o {}: another run is writing it", target)};
    }
    if (is_still_named(path, descriptor)) {
      note_temporary(path);
      return std::unique_ptr<FileLock>(new FileLock(path, descriptor));
    }
    ::close(descriptor);
  }
}

void FileLock::remove_stale(const std::string& folder) {
  std::error_code error;
  std::filesystem::directory_iterator entries(folder, error);
  for (; !error && entries != std::filesystem::directory_iterator(); entries.increment(error)) {
    const std::string name = entries->path().filename().string();
    if (!name.starts_with(kLockPrefix) || !name.ends_with(kLockSuffix)) continue;
    const std::string path = entries->path().string();
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0) continue;
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && is_still_named(path, descriptor))
      ::unlink(path.c_str());
    ::close(descriptor);
  }
}

FileLock::~FileLock() {
  forget_temporary(path_);  // first: once it is removed, the name may be another run's
  // Removed while it is held: whoever opened it meanwhile finds that it has lost its name.
  ::unlink(path_.c_str());
  ::close(descriptor_);
}

}  // namespace pentimento
