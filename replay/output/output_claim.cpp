#include "replay/output/output_claim.h"

#include <set>
#include <utility>

#include "formats/io/file_place.h"
#include "formats/io/part_file.h"

namespace pentimento {

namespace {
/// Standard output, pipes and devices are nobody's: they are not replaced but written to.
bool is_file(const std::string& output) {
  return output != "-" && place_of(output).has_value();
}
}  // namespace

Result<OutputClaim> OutputClaim::take(const std::vector<std::string>& patterns,
                                      const std::vector<std::string>& outputs,
                                      const std::vector<InputFile>& inputs) {
  // One file has one writer here, and is no input, ...
  if (Result<void> apart = check_outputs_differ(outputs); !apart) return apart.error();
  if (Result<void> stay = check_inputs_stay(outputs, inputs); !stay) return stay.error();
  // ... what dead runs left goes, ...
  std::set<std::string> folders;
  for (const std::string& output : outputs)
    if (is_file(output)) folders.insert(folder_of(follow_links(output)));
  for (const std::string& folder : folders) {
    static_cast<void>(remove_stale_parts(folder));
    FileLock::remove_stale(folder);
  }
  // ... and other runs see that the outputs are taken.
  OutputClaim claim;
  for (const std::string& pattern : patterns) {
    if (!is_file(pattern)) continue;
    Result<std::unique_ptr<FileLock>> lock = FileLock::take(pattern);
    if (!lock) return lock.error();
    claim.locks_.push_back(std::move(*lock));
  }
  return claim;
}

}  // namespace pentimento
