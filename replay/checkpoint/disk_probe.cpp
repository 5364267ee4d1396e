#include "replay/checkpoint/disk_probe.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/checkpoint/synced_file.h"

namespace pentimento {

namespace {
constexpr std::size_t kMebibyte = std::size_t{1} << 20;
constexpr double kLeast_s = 1e-9;  // a clock may not have moved

/// A file that is removed however the probe ends.
class Removed {
 public:
  explicit Removed(std::string path) : path_(std::move(path)) {}
  ~Removed() { ::unlink(path_.c_str()); }
  Removed(const Removed&) = delete;
  Removed& operator=(const Removed&) = delete;

 private:
  std::string path_;
};

/// Some file systems pack what they write, and zeros would take no time.
std::vector<std::uint64_t> mebibyte_of_noise() {
  std::vector<std::uint64_t> words(kMebibyte / sizeof(std::uint64_t));
  std::uint64_t state = 1;
  for (std::uint64_t& word : words) {
    state = state * 6364136223846793005U + 1442695040888963407U;  // Knuth, MMIX
    word = state;
  }
  return words;
}
}  // namespace

Result<double> time_of_writing_s(const std::string& path, int mebibytes) {
  const std::vector<std::uint64_t> noise = mebibyte_of_noise();
  const std::string_view piece(reinterpret_cast<const char*>(noise.data()), kMebibyte);
  const auto begin = std::chrono::steady_clock::now();
  Result<std::unique_ptr<checkpoint::SyncedFile>> file = checkpoint::SyncedFile::create(path);
  if (!file) return file.error();
  const Removed removed(path);
  for (int i = 0; i < mebibytes; ++i) (*file)->write(piece);
  if (Result<void> synced = (*file)->sync(); !synced) return synced.error();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  return std::max(taken.count(), kLeast_s);
}

}  // namespace pentimento
