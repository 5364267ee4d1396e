#pragma once
// The files that a pattern with `*`, `?` and `[...]` matches.

#include <string>
#include <vector>

namespace pentimento {

struct MatchingFile {
  std::string path;  // as the folder sees it
  std::string name;  // from the pattern's first folder with a wildcard on, without the log's ending
};

/// In the order of their paths; none if `pattern` has no wildcard. `pattern` is seen from `folder`.
std::vector<MatchingFile> matching_files(const std::string& folder, const std::string& pattern);

}  // namespace pentimento
