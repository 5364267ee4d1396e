#pragma once
// A packet: up to 64 fine cells of a row under a stamp, which are worked on as whole vectors. The
// vectors hold a few cells more than the packet; those have a tip of value 0, which leaves them as
// they are, bit for bit.

#include <algorithm>

#include "core/base/check.h"
#include "core/layers/cell_packet.h"

namespace pentimento {

inline constexpr int kVectorCells = 16;  // of the widest vectors

/// Which cells of a tile's row are worked on together.
struct StampPacket {
  int first = 0;           // the row's cell with which the vectors begin
  int cells = 0;           // in the vectors: a multiple of kVectorCells
  int begin = 0, end = 0;  // the packet's own cells, counted from `first`

  std::size_t size() const { return static_cast<std::size_t>(cells); }
  int own() const { return end - begin; }
};

/// The packet of the cells [x, x + own) of a row of `side` cells. `own` in [1, kPacketCells];
/// `side` is at least kPacketCells. The vectors stay within the row.
inline StampPacket packet_at(int x, int own, int side) {
  PENTIMENTO_CHECK(own >= 1 && own <= kPacketCells && side >= kPacketCells);
  const int cells = (own + kVectorCells - 1) / kVectorCells * kVectorCells;
  const int first = std::min(x, side - cells);
  return {first, cells, x - first, x - first + own};
}

}  // namespace pentimento
