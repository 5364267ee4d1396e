#include "replay/output/film_frames.h"

#include "formats/checkpoint/slot_file.h"

namespace pentimento {

namespace {
std::uint64_t checksum_of_frame(std::span<const std::uint8_t> frame) {
  return checkpoint::checksum_of({reinterpret_cast<const char*>(frame.data()), frame.size()});
}
}  // namespace

Result<std::unique_ptr<FilmFrames>> FilmFrames::create(const std::string& path,
                                                       std::size_t frame_bytes) {
  return go_on(path, frame_bytes, {}, {});
}

Result<std::unique_ptr<FilmFrames>> FilmFrames::go_on(
    const std::string& path, std::size_t frame_bytes, const std::vector<std::uint64_t>& checksums,
    const std::function<Result<void>(std::span<const std::uint8_t>)>& shown) {
  using checkpoint::PlacedReader;
  using checkpoint::SyncedFile;
  Result<std::unique_ptr<SyncedFile>> file =
      checksums.empty() ? SyncedFile::create(path)
                        : SyncedFile::go_on(path, frame_bytes * checksums.size());
  if (!file) return file.error();
  std::unique_ptr<FilmFrames> frames(new FilmFrames(std::move(*file)));
  if (checksums.empty()) return frames;
  Result<std::unique_ptr<PlacedReader>> reader = PlacedReader::open(path);
  if (!reader) return reader.error();
  std::vector<std::uint8_t> frame(frame_bytes);
  for (std::size_t i = 0; i < checksums.size(); ++i) {
    const std::span<char> bytes(reinterpret_cast<char*>(frame.data()), frame.size());
    if (Result<void> read = (*reader)->read(i * frame_bytes, bytes); !read) return read.error();
    if (checksum_of_frame(frame) != checksums[i])
      return Error{ErrorCode::kBadInput, path + ": a frame is damaged"};
    if (Result<void> seen = shown(frame); !seen) return seen.error();
  }
  frames->checksums_ = checksums;
  return frames;
}

void FilmFrames::add(std::span<const std::uint8_t> frame) {
  file_->write({reinterpret_cast<const char*>(frame.data()), frame.size()});
  checksums_.push_back(checksum_of_frame(frame));
}

}  // namespace pentimento
