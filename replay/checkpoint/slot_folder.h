#pragma once
// The folder of a checkpoint: which slots it has, and which files may go away. One run at a time
// may use it.

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace pentimento {

class SlotFolder {
 public:
  /// Makes the folder if it is not there. Errors: kUsage (another run uses it), kIo.
  static Result<std::unique_ptr<SlotFolder>> open(const std::string& path);
  ~SlotFolder();
  SlotFolder(const SlotFolder&) = delete;
  SlotFolder& operator=(const SlotFolder&) = delete;

  const std::string& path() const { return path_; }
  /// The generations that have a slot, the newest first.
  std::vector<std::uint64_t> slots() const;
  /// A generation that no file in the folder has.
  std::uint64_t next_generation() const;
  std::string slot_file(std::uint64_t generation) const;

  /// Removes the slots that are not among `slots`, and the planes that are not among `planes`.
  void keep_only(const std::set<std::uint64_t>& slots, const std::set<std::uint64_t>& planes) const;
  /// Removes all files of the checkpoint, and the folder if nothing else is in it.
  void clear() const;

 private:
  SlotFolder(std::string path, int descriptor);
  std::string path_;
  int descriptor_;  // holds the lock
};

}  // namespace pentimento
