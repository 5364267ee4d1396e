#pragma once
// Says to other runs that an output is being written. The lock is a small file beside the target;
// the kernel takes it from a process that dies, so that a killed run blocks nobody.

#include <memory>
#include <string>

#include "core/base/result.h"

namespace pentimento {

class FileLock {
 public:
  /// Locks the name `target`, which need not exist; links are followed. The file of the lock is
  /// ".pentimento-" and a hash of the name, and goes when the lock does. Nothing where the file
  /// system has no locks. Errors: kUsage, another process holds the lock, or this one does; kIo,
  /// the folder takes no files.
  static Result<std::unique_ptr<FileLock>> take(const std::string& target);
  /// Removes the files of locks that nobody holds any more, which killed runs left in `folder`.
  static void remove_stale(const std::string& folder);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  FileLock(std::string path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}
  std::string path_;
  int descriptor_;
};

}  // namespace pentimento
