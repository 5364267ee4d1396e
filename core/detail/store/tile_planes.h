#pragma once
// The planes of a tile by number, so that they can be saved and brought back one by one.

#include <functional>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/detail/store/detail_canvas.h"
#include "core/detail/store/detail_checkpoint.h"

namespace pentimento {

/// A plane of a tile: 0 is the base, 1 the depth, then come the pigments as [layer * channels +
/// channel], then the bands of the reflectance.
struct TilePlaneId {
  int tile = 0;
  int plane = 0;
  friend auto operator<=>(const TilePlaneId&, const TilePlaneId&) = default;
};

/// All planes that the tile has, ascending; none if it does not exist.
std::vector<TilePlaneId> planes_of(const DetailCanvas& canvas, int tile);
/// The floats of a plane that the tile has.
std::span<const float> values_of(const DetailCanvas& canvas, TilePlaneId id);

/// All planes that tiles have according to a checkpoint of `canvas`.
std::vector<TilePlaneId> planes_in(const DetailCheckpoint& checkpoint, const DetailCanvas& canvas);

/// Fills `out` with the values of a plane.
using PlaneReader = std::function<Result<void>(TilePlaneId id, std::span<float> out)>;

/// Gives a clear canvas the planes that the checkpoint lists, and the open cells. Memory is trimmed
/// to the store's budget meanwhile. Errors: those of `read`; canvas.problem().
Result<void> restore_tiles(DetailCanvas& canvas, const DetailCheckpoint& checkpoint,
                           const PlaneReader& read);

}  // namespace pentimento
