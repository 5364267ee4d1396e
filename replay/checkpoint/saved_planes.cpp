#include "replay/checkpoint/saved_planes.h"

#include <filesystem>
#include <numeric>
#include <utility>
#include <vector>

namespace pentimento {

using checkpoint::PlaneFiles;
using checkpoint::PlaneIndex;
using checkpoint::SyncedFile;

namespace {
// Files of older slots also hold planes that have changed since. When they are so many times larger
// than the planes, all planes are written anew.
constexpr std::int64_t kMostWaste = 2;

std::int64_t plane_bytes(const DetailCanvas& canvas) {
  const std::int64_t side = canvas.layout().side();
  return side * side * static_cast<std::int64_t>(sizeof(float));
}

std::vector<int> all_tiles(const DetailCanvas& canvas) {
  std::vector<int> tiles(static_cast<std::size_t>(canvas.layout().tiles()));
  std::iota(tiles.begin(), tiles.end(), 0);
  return tiles;
}
}  // namespace

Result<void> SavedPlanes::recall(const checkpoint::DetailNotes& notes, PlaneIndex index,
                                 const CanvasState& guide, DetailFollower& follower) {
  PlaneFiles files(folder_, index);
  Result<void> recalled =
      follower.recall(notes.checkpoint, notes.lock, guide,
                      [&](TilePlaneId id, std::span<float> out) { return files.read(id, out); });
  if (!recalled) return recalled;
  commit(std::move(index), follower);
  return {};
}

bool SavedPlanes::wastes_disk(const DetailCanvas& canvas) const {
  std::int64_t on_disk = 0;
  for (const std::uint64_t generation : index_.generations()) {
    std::error_code problem;
    const auto size =
        std::filesystem::file_size(checkpoint::plane_file(folder_, generation), problem);
    if (!problem) on_disk += static_cast<std::int64_t>(size);
  }
  const auto planes = static_cast<std::int64_t>(index_.planes());
  return on_disk > kMostWaste * planes * plane_bytes(canvas);
}

Result<PlaneIndex> SavedPlanes::save(const DetailFollower& follower, std::uint64_t generation) {
  const DetailCanvas& canvas = follower.canvas();
  const bool anew = wastes_disk(canvas);
  PlaneIndex index = anew ? PlaneIndex() : index_;
  bytes_saved_ = 0;
  std::unique_ptr<SyncedFile> file;
  for (const int tile : anew ? all_tiles(canvas) : follower.touched()) {
    index.forget(tile);
    for (const TilePlaneId id : planes_of(canvas, tile)) {
      if (!file) {
        Result<std::unique_ptr<SyncedFile>> created =
            SyncedFile::create(checkpoint::plane_file(folder_, generation));
        if (!created) return created.error();
        file = std::move(*created);
      }
      append_plane(id, values_of(canvas, id), generation, *file, index);
    }
  }
  if (!file) return index;
  bytes_saved_ = static_cast<std::int64_t>(file->size());
  if (Result<void> synced = file->sync(); !synced) return synced.error();
  return index;
}

void SavedPlanes::commit(PlaneIndex index, DetailFollower& follower) {
  index_ = std::move(index);
  follower.forget_touched();
}

std::int64_t SavedPlanes::bytes_to_save(const DetailFollower& follower) const {
  std::size_t planes = 0;
  for (const int tile : follower.touched()) planes += planes_of(follower.canvas(), tile).size();
  return static_cast<std::int64_t>(planes) * plane_bytes(follower.canvas());
}

}  // namespace pentimento
