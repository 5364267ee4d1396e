#pragma once
// Which tiles of the detail canvas a part of a step concerns.

#include <cstdint>
#include <vector>

#include "core/detail/detail_layout.h"
#include "core/fluid/paint_edges.h"

namespace pentimento {

/// One flag per tile of the layout: whether an edge of the guide moves in it or at its border, in
/// the cells of `runs`; and its eight neighbours, into which that paint may come.
std::vector<std::uint8_t> moving_tiles(const DetailLayout& layout, const PaintEdges& edges,
                                       const std::vector<conservative::Run>& runs);

/// Adds the neighbours of all flagged tiles.
void spread_flags(const DetailLayout& layout, std::vector<std::uint8_t>& flag);

}  // namespace pentimento
