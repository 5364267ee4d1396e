#include "replay/estimate/disk_check.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/statvfs.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "formats/io/part_file.h"

namespace pentimento {

namespace {
// The least that compression leaves of a picture: of the samples, a bare canvas with some strokes
// keeps a seventh, and the others a quarter or more.
constexpr double kLeastPicture = 0.1;
// Of what is foreseen of a detail canvas: the estimate is right within a factor of 1.2.
constexpr double kLeastScratch = 0.8;
constexpr std::int64_t kBytesPerMebibyte = 1 << 20;

/// Whether the output is a file beside which a temporary one will lie.
bool is_file(const std::string& path) {
  struct stat status {};
  return path != "-" && (::stat(path.c_str(), &status) != 0 || S_ISREG(status.st_mode));
}
}  // namespace

std::int64_t free_bytes(const std::string& folder) {
  struct statvfs system {};
  if (::statvfs(folder.c_str(), &system) != 0) return std::numeric_limits<std::int64_t>::max();
  return static_cast<std::int64_t>(system.f_bavail) * static_cast<std::int64_t>(system.f_frsize);
}

/// How much of it lies in which folder is not known where there are several; those are not judged.
std::vector<DiskUse> disk_uses(const RenderJob& job, const JobNeeds& needs) {
  std::set<std::string> folders;
  for (const std::string& output : job.picture.outputs)
    if (is_file(output)) folders.insert(folder_of(output));
  std::vector<DiskUse> uses;
  if (folders.size() == 1) {
    uses.push_back({*folders.begin(), kLeastPicture * static_cast<double>(needs.picture_bytes)});
  }
  if (!job.scratch.empty()) {
    // What memory holds is not written.
    const double held = static_cast<double>(needs.resident_bytes);
    const double foreseen = kLeastScratch * static_cast<double>(needs.scratch_bytes);
    uses.push_back({job.scratch, std::max(0.0, foreseen - held)});
  }
  return uses;
}

Result<void> check_disk(const std::vector<DiskUse>& uses) {
  std::map<dev_t, double> needed;
  for (const DiskUse& use : uses) {
    struct stat status {};
    if (::stat(use.folder.c_str(), &status) != 0) continue;  // who opens a file there says so
    const double bytes = needed[status.st_dev] += use.bytes;
    const std::int64_t room = free_bytes(use.folder);
    if (bytes <= static_cast<double>(room)) continue;
    return Error{ErrorCode::kLimit,
                 fmt::format("{}: what is written there takes {:.0f} MiB or more, and the disk has "
                             "{} MiB left; a smaller picture or another disk is needed",
                             use.folder, bytes / kBytesPerMebibyte, room / kBytesPerMebibyte)};
  }
  return {};
}

}  // namespace pentimento
