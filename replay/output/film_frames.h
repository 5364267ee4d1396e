#pragma once
// The frames of a film that is being made, in a file: an encoder cannot be saved, so a film that
// was interrupted is encoded from its frames again.

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "formats/checkpoint/synced_file.h"

namespace pentimento {

class FilmFrames {
 public:
  /// A new file. Errors: kIo.
  static Result<std::unique_ptr<FilmFrames>> create(const std::string& path,
                                                    std::size_t frame_bytes);
  /// Reads the frames with these checksums, hands each to `shown`, and goes on after them. Errors:
  /// kIo, kBadInput for frames that are damaged, those of `shown`.
  static Result<std::unique_ptr<FilmFrames>> go_on(
      const std::string& path, std::size_t frame_bytes, const std::vector<std::uint64_t>& checksums,
      const std::function<Result<void>(std::span<const std::uint8_t>)>& shown);

  void add(std::span<const std::uint8_t> frame);
  /// Of each frame.
  const std::vector<std::uint64_t>& checksums() const { return checksums_; }
  /// All frames are on the disk. Errors: kIo.
  Result<void> sync() { return file_->sync(); }

 private:
  explicit FilmFrames(std::unique_ptr<checkpoint::SyncedFile> file) : file_(std::move(file)) {}
  std::unique_ptr<checkpoint::SyncedFile> file_;
  std::vector<std::uint64_t> checksums_;
};

}  // namespace pentimento
