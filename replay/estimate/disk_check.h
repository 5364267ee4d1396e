#pragma once
// Whether the disks have room for what a job will write. A job that cannot end well does not begin.

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "replay/estimate/memory_estimate.h"

namespace pentimento {

/// Files that will lie in a folder, and how large they become at least.
struct DiskUse {
  std::string folder;
  double bytes = 0;
};

/// The folders of the job's pictures and of --scratch. Dumps do not count: what is bare of paint
/// takes no room in them.
std::vector<DiskUse> disk_uses(const RenderJob& job, const JobNeeds& needs);

/// What a file system has left for this user, in the folder; a very large number where it cannot be
/// told.
std::int64_t free_bytes(const std::string& folder);

/// kLimit if a file system has less room than the files need even if they compress well: one line
/// with the folder and both sizes. Files of one file system are added.
Result<void> check_disk(const std::vector<DiskUse>& uses);

}  // namespace pentimento
