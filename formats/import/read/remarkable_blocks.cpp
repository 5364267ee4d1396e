#include "formats/import/read/remarkable_blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <list>
#include <map>
#include <utility>

#include "formats/import/read/remarkable_pens.h"

namespace pentimento::sketch {

namespace {
constexpr int kLineBlock = 5, kSceneInfoBlock = 13;
constexpr std::uint32_t kMostPage_px = 100'000;

using ItemId = std::pair<std::uint32_t, std::uint64_t>;  // (0, 0): none

/// A number in groups of 7 bits, the lowest first.
std::uint64_t varuint(ByteReader& in, std::string_view field) {
  std::uint64_t value = 0;
  for (int shift = 0; shift < 64; shift += 7) {
    const std::uint64_t byte = in.u8(field);
    value |= (byte & 127) << shift;
    if (byte < 128) return value;
  }
  in.fail(fmt::format("{} has more than ten bytes", field));
  return 0;
}

/// A tagged value: its number in the block, and what it holds by its kind.
struct TaggedValue {
  std::uint64_t index = 0;
  ItemId id;               // kind 15
  std::string_view bytes;  // kinds 12, 8, 4, 1
  std::size_t offset = 0;  // of the bytes
};

TaggedValue next_value(ByteReader& in) {
  const std::uint64_t tag = varuint(in, "tag");
  TaggedValue out;
  out.index = tag >> 4;
  const std::uint64_t kind = tag & 15;
  if (kind == 15) {
    out.id.first = in.u8("id");
    out.id.second = varuint(in, "id");
    return out;
  }
  if (kind != 12 && kind != 8 && kind != 4 && kind != 1) {
    in.fail(fmt::format("a value of kind {} is not known", kind));
    return out;
  }
  const std::size_t length = kind == 12 ? in.u32("length of a value") : kind;
  out.offset = in.offset();
  out.bytes = in.bytes(length, "value");
  return out;
}

/// A line of a group; one that was deleted has no stroke but still a place in the order.
struct LineItem {
  ItemId parent, id, left;
  bool deleted = true;
  Stroke stroke;
};

class BlockReader {
 public:
  BlockReader(ByteReader& in, std::string name) : in_(in), name_(std::move(name)) {}

  Result<RemarkableScene> read() {
    while (in_.left() > 0 && in_.ok()) read_block();
    if (!in_.ok()) return in_.error();
    int layer = 0;
    for (const ItemId& group : groups_) {
      for (LineItem& item : lines_[group]) {
        if (item.deleted) {
          ++scene_.deleted;
          continue;
        }
        item.stroke.layer = layer;
        if (!item.stroke.samples.empty()) scene_.strokes.push_back(std::move(item.stroke));
      }
      ++layer;
    }
    return std::move(scene_);
  }

 private:
  void read_block() {
    const std::uint32_t length = in_.u32("length of a block");
    in_.skip(2, "versions");
    const int version = in_.u8("version"), type = in_.u8("type");
    const std::size_t offset = in_.offset();
    ByteReader block(name_, in_.bytes(length, "block"), offset);
    if (!in_.ok()) return;
    if (type == kLineBlock) read_line(block, version);
    if (type == kSceneInfoBlock) read_info(block);
    if (!block.ok()) in_.adopt(block);
  }

  void read_info(ByteReader& block) {
    while (block.left() > 0 && block.ok()) {
      const TaggedValue value = next_value(block);
      if (value.index != 5 || value.bytes.size() != 8) continue;
      ByteReader size(name_, value.bytes, value.offset);
      const std::uint32_t width = size.u32("width"), height = size.u32("height");
      if (width == 0 || height == 0 || width > kMostPage_px || height > kMostPage_px)
        return block.fail(fmt::format("a page of {} x {} px", width, height));
      scene_.width_px = width;
      scene_.height_px = height;
    }
  }

  void read_line(ByteReader& block, int version) {
    LineItem item;
    while (block.left() > 0 && block.ok()) {
      const TaggedValue value = next_value(block);
      if (value.index == 1) item.parent = value.id;
      if (value.index == 2) item.id = value.id;
      if (value.index == 3) item.left = value.id;
      if (value.index != 6 || value.bytes.empty()) continue;
      ByteReader line(name_, value.bytes, value.offset);
      line.skip(1, "kind of item");
      item.deleted = false;
      read_stroke(line, version, item.stroke);
      if (!line.ok()) block.adopt(line);
    }
    if (block.ok()) insert(std::move(item));
  }

  void read_stroke(ByteReader& line, int version, Stroke& stroke) {
    std::uint32_t pen = 0, color = 0, argb = 0;
    while (line.left() > 0 && line.ok()) {
      const TaggedValue value = next_value(line);
      ByteReader in(name_, value.bytes, value.offset);
      if (value.index == 1) pen = in.u32("pen");
      if (value.index == 2) color = in.u32("colour");
      if (value.index == 8 && value.bytes.size() == 4) argb = in.u32("colour");
      if (value.index == 5) read_points(in, version, stroke);
      if (!in.ok()) return line.adopt(in);
    }
    set_pen(pen, stroke);
    set_pen_color(color, argb, stroke);
  }

  static void read_points(ByteReader& in, int version, Stroke& stroke) {
    const std::size_t bytes = version < 2 ? kLongPointBytes : kShortPointBytes;
    while (in.left() >= bytes && in.ok())
      version < 2 ? read_long_point(in, stroke) : read_short_point(in, stroke);
    if (in.left() > 0) in.fail(fmt::format("{} bytes are no point", in.left()));
  }

  /// After its left neighbour; at the beginning if it has none. The file's order is not the
  /// drawing's.
  void insert(LineItem item) {
    std::list<LineItem>& list = lines_[item.parent];
    if (list.empty()) groups_.push_back(item.parent);
    const auto left = places_.find(item.left);
    const bool here = left != places_.end() && left->second->parent == item.parent;
    auto before = here                    ? std::next(left->second)
                  : item.left == ItemId{} ? list.begin()
                                          : list.end();
    const ItemId id = item.id;
    places_[id] = list.insert(before, std::move(item));
  }

  ByteReader& in_;
  std::string name_;
  RemarkableScene scene_;
  std::map<ItemId, std::list<LineItem>> lines_;
  std::map<ItemId, std::list<LineItem>::iterator> places_;
  std::vector<ItemId> groups_;  // in the order of their first line
};

}  // namespace

Result<RemarkableScene> read_remarkable_blocks(ByteReader& in) {
  return BlockReader(in, in.name()).read();
}

}  // namespace pentimento::sketch
