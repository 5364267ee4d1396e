#include "replay/checkpoint/slot_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

namespace pentimento {

namespace {
/// A file of a checkpoint: NUMBER.EXTENSION.
struct NumberedFile {
  std::string name;
  std::uint64_t number = 0;
  std::string_view extension() const { return std::string_view(name).substr(name.find('.') + 1); }
};

std::optional<NumberedFile> numbered(const std::string& name) {
  NumberedFile file{name, 0};
  const char* end = name.data() + name.size();
  const auto [rest, problem] = std::from_chars(name.data(), end, file.number);
  if (problem != std::errc() || rest == end || *rest != '.') return std::nullopt;
  constexpr std::string_view kExtensions[] = {"slot", "slot.part", "planes", "output", "frames"};
  const bool ours = std::find(std::begin(kExtensions), std::end(kExtensions), file.extension()) !=
                    std::end(kExtensions);
  return ours ? std::optional(file) : std::nullopt;
}

std::vector<NumberedFile> files_in(const std::string& folder) {
  std::vector<NumberedFile> files;
  std::error_code problem;
  for (std::filesystem::directory_iterator entry(folder, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    if (const auto file = numbered(entry->path().filename().string())) files.push_back(*file);
  }
  return files;
}

void remove_file(const std::string& folder, const NumberedFile& file) {
  ::unlink((folder + "/" + file.name).c_str());
}
}  // namespace

SlotFolder::SlotFolder(std::string path, int descriptor)
    : path_(std::move(path)), descriptor_(descriptor) {}

SlotFolder::~SlotFolder() {
  ::close(descriptor_);
}

Result<std::unique_ptr<SlotFolder>> SlotFolder::open(const std::string& path) {
  const auto io_error = [&](int error_number) {
    return Error{ErrorCode::kIo,
                 fmt::format("--checkpoint {}: {}", path, std::strerror(error_number))};
  };
  if (::mkdir(path.c_str(), 0777) != 0 && errno != EEXIST) return io_error(errno);
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return io_error(errno);
  std::unique_ptr<SlotFolder> folder(new SlotFolder(path, descriptor));
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return folder;
  if (errno != EWOULDBLOCK) return io_error(errno);
  return Error{ErrorCode::kUsage, fmt::format("--checkpoint {}: another run uses it", path)};
}

std::vector<std::uint64_t> SlotFolder::slots() const {
  std::vector<std::uint64_t> generations;
  for (const NumberedFile& file : files_in(path_))
    if (file.extension() == "slot") generations.push_back(file.number);
  std::sort(generations.rbegin(), generations.rend());
  return generations;
}

std::uint64_t SlotFolder::next_generation() const {
  std::uint64_t next = 1;
  for (const NumberedFile& file : files_in(path_)) next = std::max(next, file.number + 1);
  return next;
}

std::string SlotFolder::slot_file(std::uint64_t generation) const {
  return fmt::format("{}/{}.slot", path_, generation);
}

void SlotFolder::keep_only(const std::set<std::uint64_t>& slots,
                           const std::set<std::uint64_t>& planes) const {
  for (const NumberedFile& file : files_in(path_)) {
    const bool slot = file.extension().starts_with("slot");
    if (slot && !slots.contains(file.number)) remove_file(path_, file);
    if (file.extension() == "planes" && !planes.contains(file.number)) remove_file(path_, file);
  }
}

void SlotFolder::clear() const {
  // The newest slot goes last, so that one that is left after a crash here is not an old one.
  std::vector<NumberedFile> files = files_in(path_);
  std::sort(files.begin(), files.end(), [](const NumberedFile& a, const NumberedFile& b) {
    return std::pair(a.extension() != "slot", a.number) <
           std::pair(b.extension() != "slot", b.number);
  });
  for (const NumberedFile& file : files) remove_file(path_, file);
  ::rmdir(path_.c_str());
}

}  // namespace pentimento
