#include "formats/checkpoint/plane_index.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/base/finite.h"
#include "formats/checkpoint/slot_file.h"

namespace pentimento::checkpoint {

namespace {
constexpr std::size_t kEntryBytes = 4 + 4 + 8 + 8 + 8;

std::string_view bytes_of(std::span<const float> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}
}  // namespace

void PlaneIndex::forget(int tile) {
  places_.erase(places_.lower_bound({tile, 0}),
                places_.upper_bound({tile, std::numeric_limits<int>::max()}));
}

const PlanePlace* PlaneIndex::find(TilePlaneId id) const {
  const auto found = places_.find(id);
  return found == places_.end() ? nullptr : &found->second;
}

std::set<std::uint64_t> PlaneIndex::generations() const {
  std::set<std::uint64_t> all;
  for (const auto& [id, place] : places_) all.insert(place.generation);
  return all;
}

void PlaneIndex::put(ArchiveWriter& to) const {
  to.u64(places_.size());
  for (const auto& [id, place] : places_) {
    to.i32(id.tile);
    to.i32(id.plane);
    to.u64(place.generation);
    to.u64(place.offset);
    to.u64(place.checksum);
  }
}

PlaneIndex PlaneIndex::take(ArchiveReader& from) {
  PlaneIndex index;
  const std::uint64_t count = from.count(kEntryBytes);
  for (std::uint64_t i = 0; i < count && from.ok(); ++i) {
    const TilePlaneId id{from.i32(), from.i32()};
    index.set(id, {from.u64(), from.u64(), from.u64()});
  }
  return index;
}

void append_plane(TilePlaneId id, std::span<const float> values, std::uint64_t generation,
                  SyncedFile& file, PlaneIndex& index) {
  index.set(id, {generation, file.size(), checksum_of(bytes_of(values))});
  file.write(bytes_of(values));
}

Result<void> PlaneFiles::read(TilePlaneId id, std::span<float> out) {
  const auto bad = [&](std::string_view what) {
    return Error{ErrorCode::kBadInput,
                 fmt::format("{}: plane {} of tile {} {}", folder_, id.plane, id.tile, what)};
  };
  const PlanePlace* place = index_.find(id);
  if (place == nullptr) return bad("is missing");
  std::unique_ptr<PlacedReader>& file = files_[place->generation];
  if (!file) {
    Result<std::unique_ptr<PlacedReader>> opened =
        PlacedReader::open(plane_file(folder_, place->generation));
    if (!opened) return opened.error();
    file = std::move(*opened);
  }
  const std::span<char> bytes(reinterpret_cast<char*>(out.data()), out.size_bytes());
  if (Result<void> read = file->read(place->offset, bytes); !read) return read;
  if (checksum_of(bytes_of(out)) != place->checksum || !all_finite(out)) return bad("is damaged");
  return {};
}

std::string plane_file(const std::string& folder, std::uint64_t generation) {
  return fmt::format("{}/{}.planes", folder, generation);
}

}  // namespace pentimento::checkpoint
