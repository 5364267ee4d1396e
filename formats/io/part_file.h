#pragma once
// The temporary files beside an output: their names, and how those of killed runs are found and
// removed.

#include <string>

namespace pentimento {

/// The folder that holds `path`; "." for a bare name.
std::string folder_of(const std::string& path);

/// A new name for a temporary file beside `target`: ".pentimento-PLACE-PROCESS-NUMBER.part". It is
/// short whatever the target is called. PLACE stands for the machine and its numbering of
/// processes.
std::string part_name(const std::string& target);

/// Removes from `folder` the temporary files whose runs are dead: those with a name of part_name(),
/// of this machine, of this user, of a process that no longer exists. Others stay, also those of
/// another machine that shares the folder. Returns how many were removed.
int remove_stale_parts(const std::string& folder);
/// The same for folders that were made under such a name, with all that they hold.
int remove_stale_part_folders(const std::string& folder);

}  // namespace pentimento
