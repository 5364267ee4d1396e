#pragma once
// Files that are on the disk when the program says so. Errors of all functions: kIo, with the name.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace pentimento::checkpoint {

/// A file being written. The first failure stays; finish() returns it.
class SyncedFile {
 public:
  /// A new file in the place of any other of that name.
  static Result<std::unique_ptr<SyncedFile>> create(const std::string& path);
  /// Goes on writing at `size`; what the file has beyond that is cut off. Errors: also if the file
  /// is shorter.
  static Result<std::unique_ptr<SyncedFile>> go_on(const std::string& path, std::uint64_t size);
  ~SyncedFile();
  SyncedFile(const SyncedFile&) = delete;
  SyncedFile& operator=(const SyncedFile&) = delete;

  void write(std::string_view bytes);
  std::uint64_t size() const { return size_; }
  /// All bytes are on the disk. The file may be written on.
  Result<void> sync();

 private:
  SyncedFile(std::string path, int descriptor, std::uint64_t size);
  std::string path_;
  int descriptor_;
  std::uint64_t size_;
  int error_number_ = 0;
};

/// A file being read, at any place.
class PlacedReader {
 public:
  static Result<std::unique_ptr<PlacedReader>> open(const std::string& path);
  ~PlacedReader();
  PlacedReader(const PlacedReader&) = delete;
  PlacedReader& operator=(const PlacedReader&) = delete;

  std::uint64_t size() const { return size_; }
  /// Errors: kBadInput if the file ends before.
  Result<void> read(std::uint64_t offset, std::span<char> out) const;

 private:
  PlacedReader(std::string path, int descriptor, std::uint64_t size);
  std::string path_;
  int descriptor_;
  std::uint64_t size_;
};

/// Renames, and makes the new name durable. Both names lie in one folder.
Result<void> rename_synced(const std::string& from, const std::string& to);
/// Makes names in a folder durable.
Result<void> sync_folder(const std::string& folder);
/// Gives the bytes of `from` the second name `to`, or copies them where names cannot be shared.
Result<void> link_or_copy(const std::string& from, const std::string& to);

}  // namespace pentimento::checkpoint
