#include "formats/io/part_file.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>

#include "formats/io/sha256.h"

namespace pentimento {

namespace {
constexpr std::string_view kPrefix = ".pentimento-";
constexpr std::string_view kSuffix = ".part";
constexpr std::size_t kPlaceDigits = 12;  // 48 bits: two machines of one folder differ

/// Stands for what gives the number of a process its meaning: the machine's name, and the namespace
/// of processes (each container has its own).
std::string process_place() {
  struct utsname machine = {};
  static_cast<void>(::uname(&machine));
  struct stat processes = {};
  static_cast<void>(::stat("/proc/self/ns/pid", &processes));
  const std::string text = fmt::format("{} {}", machine.nodename, processes.st_ino);
  Sha256 hash;
  hash.update(text.data(), text.size());
  return hash.hex().substr(0, kPlaceDigits);
}

/// The process that made a file of this name; nothing if the name is not of part_name() or of
/// another place.
std::optional<pid_t> maker_of(std::string_view name, const std::string& place) {
  const std::string start = fmt::format("{}{}-", kPrefix, place);
  if (!name.starts_with(start) || !name.ends_with(kSuffix)) return std::nullopt;
  name.remove_prefix(start.size());
  pid_t process = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), process);
  const bool whole = error == std::errc{} && process > 0 && *end == '-';
  return whole ? std::optional(process) : std::nullopt;
}

bool is_dead(pid_t process) {
  return ::kill(process, 0) != 0 && errno == ESRCH;
}

/// Of this user, and of the kind `type` (S_IFREG or S_IFDIR); links are not followed.
bool is_own(const std::string& path, mode_t type) {
  struct stat info = {};
  return ::lstat(path.c_str(), &info) == 0 && (info.st_mode & S_IFMT) == type &&
         info.st_uid == ::geteuid();
}

/// Removes what dead processes left in `folder`, if it is of the kind `type`.
int remove_stale(const std::string& folder, mode_t type) {
  const std::string place = process_place();
  std::error_code error;
  int removed = 0;
  std::filesystem::directory_iterator entries(folder, error);
  for (; !error && entries != std::filesystem::directory_iterator(); entries.increment(error)) {
    const std::optional<pid_t> maker = maker_of(entries->path().filename().string(), place);
    if (!maker || !is_dead(*maker) || !is_own(entries->path().string(), type)) continue;
    std::error_code kept;
    std::filesystem::remove_all(entries->path(), kept);
    if (!kept) ++removed;
  }
  return removed;
}
}  // namespace

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

std::string part_name(const std::string& target) {
  static std::atomic<unsigned> counter{0};
  return fmt::format("{}/{}{}-{}-{}{}", folder_of(target), kPrefix, process_place(), ::getpid(),
                     counter++, kSuffix);
}

int remove_stale_parts(const std::string& folder) {
  return remove_stale(folder, S_IFREG);
}

int remove_stale_part_folders(const std::string& folder) {
  return remove_stale(folder, S_IFDIR);
}

}  // namespace pentimento
