#pragma once
// Where the planes of the detail canvas lie. Each slot appends only the planes of tiles that
// changed since the slot before, in a file of its own, and its index says for every plane in which
// file it is. So a slot needs files of older slots.

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>

#include "core/detail/store/tile_planes.h"
#include "formats/checkpoint/archive.h"
#include "formats/checkpoint/synced_file.h"

namespace pentimento::checkpoint {

struct PlanePlace {
  std::uint64_t generation = 0;  // of the slot whose file it is in
  std::uint64_t offset = 0;      // bytes
  std::uint64_t checksum = 0;
};

class PlaneIndex {
 public:
  /// Forgets the planes of a tile.
  void forget(int tile);
  void set(TilePlaneId id, const PlanePlace& place) { places_[id] = place; }
  /// Nullptr if there is none.
  const PlanePlace* find(TilePlaneId id) const;
  std::size_t planes() const { return places_.size(); }
  /// The generations whose files hold planes.
  std::set<std::uint64_t> generations() const;

  void put(ArchiveWriter& to) const;
  static PlaneIndex take(ArchiveReader& from);

 private:
  std::map<TilePlaneId, PlanePlace> places_;
};

/// Appends a plane to the file of `generation`, and notes its place.
void append_plane(TilePlaneId id, std::span<const float> values, std::uint64_t generation,
                  SyncedFile& file, PlaneIndex& index);

/// Reads planes from the files in `folder`. Errors: kBadInput for a plane that is missing or
/// damaged.
class PlaneFiles {
 public:
  PlaneFiles(std::string folder, const PlaneIndex& index)
      : folder_(std::move(folder)), index_(index) {}
  Result<void> read(TilePlaneId id, std::span<float> out);

 private:
  std::string folder_;
  const PlaneIndex& index_;
  std::map<std::uint64_t, std::unique_ptr<PlacedReader>> files_;
};

/// The name of a generation's file.
std::string plane_file(const std::string& folder, std::uint64_t generation);

}  // namespace pentimento::checkpoint
