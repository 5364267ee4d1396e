#include "formats/checkpoint/detail_part.h"

#include <algorithm>
#include <cmath>

namespace pentimento::checkpoint {

namespace {
constexpr std::size_t kStampedBytes = 4 + 4 + 4 + 4 + 1;  // x, y, way, now

/// Whether all layers go to layers that exist.
bool right_layers(const std::vector<std::uint32_t>& block, int layers) {
  return std::all_of(block.begin(), block.end(), [&](std::uint32_t bits) {
    for (int layer = 0; layer < layers; ++layer)
      if (static_cast<int>(bits >> (layer * kCheckpointLayerBits) & 7u) >= layers) return false;
    return true;
  });
}

StampedBlock take_stamped(const CanvasGeometry& guide, ArchiveReader& from) {
  StampedBlock block;
  block.x = from.i32();
  block.y = from.i32();
  block.way.x = from.f32();
  block.way.y = from.f32();
  block.now = from.flag();
  if (block.x < 0 || block.x >= guide.width || block.y < 0 || block.y >= guide.height)
    from.fail("the brush was beside the canvas");
  if (!(std::hypot(block.way.x, block.way.y) <= 1.01f)) from.fail("a way is no direction");
  return block;
}
}  // namespace

void put_detail(const DetailNotes& notes, ArchiveWriter& to) {
  const DetailCheckpoint& checkpoint = notes.checkpoint;
  to.list(std::span<const std::uint32_t>(checkpoint.tile));
  to.list(std::span<const std::uint32_t>(checkpoint.block));
  to.list(std::span<const std::uint32_t>(checkpoint.waiting));
  to.u64(checkpoint.stamped.size());
  for (const StampedBlock& block : checkpoint.stamped) {
    to.i32(block.x);
    to.i32(block.y);
    to.f32(block.way.x);
    to.f32(block.way.y);
    to.flag(block.now);
  }
  to.raw(std::span<const std::int64_t>(notes.lock.blocks));
  to.i64(notes.lock.owed);
}

DetailNotes take_detail(const DetailLayout& layout, int layers, int channels, ArchiveReader& from) {
  DetailNotes notes;
  DetailCheckpoint& checkpoint = notes.checkpoint;
  const DetailCheckpoint like = make_checkpoint(layout, layers * channels);
  checkpoint.tile = from.list<std::uint32_t>();
  checkpoint.block = from.list<std::uint32_t>();
  checkpoint.waiting = from.list<std::uint32_t>();
  if (checkpoint.tile.size() != like.tile.size() || checkpoint.block.size() != like.block.size() ||
      checkpoint.waiting.size() != like.waiting.size())
    from.fail("it is of another detail canvas");
  if (!right_layers(checkpoint.block, layers)) from.fail("it names a layer that there is not");
  const std::uint64_t stamped = from.count(kStampedBytes);
  for (std::uint64_t i = 0; i < stamped && from.ok(); ++i)
    checkpoint.stamped.push_back(take_stamped(layout.guide(), from));
  from.raw(std::span<std::int64_t>(notes.lock.blocks));
  notes.lock.owed = from.i64();
  return notes;
}

}  // namespace pentimento::checkpoint
