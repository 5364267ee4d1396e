#pragma once
// The file of a slot: named parts, a checksum for each, and a table of them at the end
// (docs/checkpoints.md has the bytes). It is written under another name, forced to the disk and
// renamed, so that it is whole or not there.

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "formats/checkpoint/synced_file.h"

namespace pentimento::checkpoint {

/// A checksum of 64 bits (XXH3): finds damage, not forgery.
std::uint64_t checksum_of(std::string_view bytes);

class SlotWriter {
 public:
  /// Errors: kIo.
  static Result<std::unique_ptr<SlotWriter>> create(const std::string& path);

  void add(const std::string& name, std::string_view bytes);
  /// Writes the table, and gives the file its name.
  Result<void> finish();
  std::uint64_t bytes_written() const { return file_->size(); }

 private:
  struct PartEntry {
    std::string name;
    std::uint64_t offset = 0, size = 0, checksum = 0;
  };
  SlotWriter(std::string path, std::unique_ptr<SyncedFile> file);
  std::string path_;
  std::unique_ptr<SyncedFile> file_;
  std::vector<PartEntry> parts_;
};

/// The parts of a slot by their names.
using SlotParts = std::map<std::string, std::string, std::less<>>;

/// `name` is the file's, for messages. Errors: kBadInput, for bytes that are no slot, that are
/// damaged, or that come from a newer version.
Result<SlotParts> parse_slot(std::string_view bytes, const std::string& name);

/// Errors: those of parse_slot(); kIo; kLimit for a file of more than 16 GB.
Result<SlotParts> read_slot(const std::string& path);

}  // namespace pentimento::checkpoint
