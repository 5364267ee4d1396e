#pragma once
// Where a path leads: which file it names under all its names. Two paths of one place are one file.

#include <compare>
#include <cstdint>
#include <optional>
#include <string>

namespace pentimento {

/// A file that exists is known by its device and inode, and `name` is empty. A file that does not
/// exist yet is known by the device and inode of its folder, and by its name there.
struct FilePlace {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::string name;
  auto operator<=>(const FilePlace&) const = default;
};

/// The path behind a link and behind the links that it leads to, also where no file is there yet.
/// A path that is no link, and a circle of links, come back as they are.
std::string follow_links(const std::string& path);

/// The place of a regular file, or of one that could be made there; links are followed. Nothing for
/// pipes, devices, folders, and where no folder is.
std::optional<FilePlace> place_of(const std::string& path);

/// The place of the regular file that a descriptor is open on; nothing for pipes and devices.
std::optional<FilePlace> place_of_descriptor(int descriptor);

}  // namespace pentimento
