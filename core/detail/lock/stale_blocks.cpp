#include "core/detail/lock/stale_blocks.h"

#include <algorithm>
#include <cstring>

#include "core/base/any_not_zero.h"

namespace pentimento {

namespace {
constexpr int kNotedTogether = 8;  // strips: some microseconds
constexpr int kHardlyApart = 2;    // blocks: to begin another strip costs as much as to lock these

const Field<float>& plane_of(const CanvasState& guide, std::size_t plane) {
  return plane == 0 ? guide.depth_m : guide.pigment[plane - 1];
}

/// A row's cells [x0, x1) of `from` are written to `to`, and `differs` becomes 1 where they were
/// others. A row that is equal is only read.
void note_row(const float* from, int x0, int x1, float* to, std::uint8_t* differs) {
  const auto bytes = static_cast<std::size_t>(x1 - x0) * sizeof(float);
  if (std::memcmp(from + x0, to + x0, bytes) == 0) return;
  for (int x = x0; x < x1; ++x)
    if (from[x] != to[x]) differs[x] = 1;
  std::memcpy(to + x0, from + x0, bytes);
}
}  // namespace

StaleBlocks::StaleBlocks(const DetailLayout& layout, int layers, int channels)
    : stale_(layout.guide().width, layout.guide().height),
      near_(static_cast<std::size_t>(layout.guide().width)) {
  for (int plane = 0; plane < 1 + layers * channels; ++plane)
    held_.emplace_back(layout.guide().width, layout.guide().height);
}

std::vector<BlockStrip> StaleBlocks::find(const CanvasState& guide, const ChangedBlocks& changed,
                                          const ChangedBlocks& reworked, const Threads& threads) {
  const std::vector<BlockStrip> strips = changed.strips(), others = reworked.strips();
  const auto mark = [&](const BlockStrip& strip, std::uint8_t value) {
    std::fill(stale_.row(strip.y) + strip.x0, stale_.row(strip.y) + strip.x1, value);
  };
  // Which blocks are stale: those that were reworked, and those of which the guide holds more or
  // less than it did.
  for (const BlockStrip& strip : others) mark(strip, 1);
  threads.for_ranges(0, static_cast<int>(strips.size()), kNotedTogether, [&](int begin, int end) {
    // No two strips have a cell in common.
    for (int i = begin; i < end; ++i) {
      const BlockStrip& strip = strips[static_cast<std::size_t>(i)];
      for (std::size_t plane = 0; plane < held_.size(); ++plane)
        note_row(plane_of(guide, plane).row(strip.y), strip.x0, strip.x1, held_[plane].row(strip.y),
                 stale_.row(strip.y));
    }
  });
  // These, and the blocks next to them.
  std::vector<BlockStrip> found;
  for (const BlockStrip& strip : strips) add_near(strip, found);
  for (const auto* list : {&strips, &others})
    for (const BlockStrip& strip : *list) mark(strip, 0);
  return found;
}

/// Adds the parts of a strip that are stale or next to a stale block.
void StaleBlocks::add_near(const BlockStrip& strip, std::vector<BlockStrip>& found) {
  const int y0 = std::max(strip.y - 1, 0), y1 = std::min(strip.y + 2, stale_.height());
  const int first = std::max(strip.x0 - 1, 0), last = std::min(strip.x1 + 1, stale_.width());
  const auto column = [&](int x) -> std::uint8_t& { return near_[static_cast<std::size_t>(x)]; };
  for (int x = first; x < last; ++x) {
    column(x) = 0;
    for (int y = y0; y < y1; ++y) column(x) |= stale_(x, y);
  }
  BlockStrip part{strip.tile, strip.y, 0, 0};
  for (int x = strip.x0; x < strip.x1; ++x) {
    const bool is_near =
        column(x) != 0 || (x > first && column(x - 1) != 0) || (x + 1 < last && column(x + 1) != 0);
    if (!is_near) continue;
    if (part.x1 > 0 && x - part.x1 > kHardlyApart) {
      found.push_back(part);
      part.x1 = 0;
    }
    if (part.x1 == 0) part.x0 = x;
    part.x1 = x + 1;
  }
  if (part.x1 > 0) found.push_back(part);
}

void StaleBlocks::note(const CanvasState& guide) {
  for (std::size_t plane = 0; plane < held_.size(); ++plane) {
    for (int y = 0; y < stale_.height(); ++y) {
      note_row(plane_of(guide, plane).row(y), 0, stale_.width(), held_[plane].row(y),
               stale_.row(y));
      std::fill_n(stale_.row(y), stale_.width(), std::uint8_t{0});
    }
  }
}

void StaleBlocks::clear() {
  for (Field<float>& plane : held_)
    for (int y = 0; y < plane.height(); ++y)
      if (any_not_zero(plane.row(y), plane.width())) std::fill_n(plane.row(y), plane.width(), 0.0f);
}

}  // namespace pentimento
