#include "core/detail/store/tile_planes.h"

namespace pentimento {

namespace {
constexpr int kBasePlane = 0, kDepthPlane = 1, kFirstPigmentPlane = 2;
constexpr int kPlanesBetweenTrims = 1024;

std::size_t plane_index(int i) {
  return static_cast<std::size_t>(i);
}

int pigments_of(const DetailCanvas& canvas) {
  return canvas.layers() * canvas.channels();
}

/// The plane, which the tile may lack.
TilePlane& plane_of(DetailTile& tile, const DetailCanvas& canvas, int plane) {
  if (plane == kBasePlane) return tile.base_m;
  if (plane == kDepthPlane) return tile.depth_m;
  const int pigment = plane - kFirstPigmentPlane;
  if (pigment < pigments_of(canvas)) return tile.pigment[plane_index(pigment)];
  return tile.reflectance[plane_index(pigment - pigments_of(canvas))];
}
}  // namespace

std::vector<TilePlaneId> planes_of(const DetailCanvas& canvas, int tile) {
  std::vector<TilePlaneId> ids;
  const DetailTile* made = canvas.find(tile);
  if (made == nullptr) return ids;
  if (made->base_m) ids.push_back({tile, kBasePlane});
  if (made->depth_m) ids.push_back({tile, kDepthPlane});
  const int pigments = pigments_of(canvas);
  for (int p = 0; p < pigments; ++p)
    if (made->pigment[plane_index(p)]) ids.push_back({tile, kFirstPigmentPlane + p});
  for (std::size_t band = 0; band < made->reflectance.size(); ++band)
    ids.push_back({tile, kFirstPigmentPlane + pigments + static_cast<int>(band)});
  return ids;
}

std::span<const float> values_of(const DetailCanvas& canvas, TilePlaneId id) {
  const DetailTile* tile = canvas.find(id.tile);
  PENTIMENTO_CHECK(tile != nullptr);
  const int pigment = id.plane - kFirstPigmentPlane;
  const TilePlane& plane = id.plane == kBasePlane    ? tile->base_m
                           : id.plane == kDepthPlane ? tile->depth_m
                           : pigment < pigments_of(canvas)
                               ? tile->pigment[plane_index(pigment)]
                               : tile->reflectance[plane_index(pigment - pigments_of(canvas))];
  const std::size_t side = plane_index(canvas.layout().side());
  return {plane.data(), side * side};
}

std::vector<TilePlaneId> planes_in(const DetailCheckpoint& checkpoint, const DetailCanvas& canvas) {
  std::vector<TilePlaneId> ids;
  const int pigments = pigments_of(canvas);
  const int columns = kCheckpointPigment + pigments;
  for (int t = 0; t < canvas.layout().tiles(); ++t) {
    const std::uint32_t* row = checkpoint.tile.data() + plane_index(t) * plane_index(columns);
    if (row[kCheckpointMade] == 0) continue;
    ids.push_back({t, kBasePlane});
    if (row[kCheckpointDepth] != 0) ids.push_back({t, kDepthPlane});
    for (int p = 0; p < pigments; ++p)
      if (row[kCheckpointPigment + p] != 0) ids.push_back({t, kFirstPigmentPlane + p});
    for (int band = 0; row[kCheckpointDried] != 0 && band < canvas.bands(); ++band)
      ids.push_back({t, kFirstPigmentPlane + pigments + band});
  }
  return ids;
}

Result<void> restore_tiles(DetailCanvas& canvas, const DetailCheckpoint& checkpoint,
                           const PlaneReader& read) {
  const std::size_t side = plane_index(canvas.layout().side());
  int since_trim = 0;
  for (const TilePlaneId id : planes_in(checkpoint, canvas)) {
    DetailTile& tile = canvas.at(id.tile);
    if (id.plane >= kFirstPigmentPlane + pigments_of(canvas))
      tile.reflectance.resize(plane_index(canvas.bands()));
    TilePlane& plane = plane_of(tile, canvas, id.plane);
    if (!plane && !canvas.make(plane)) return canvas.problem();
    plane.mark_used();
    if (Result<void> filled = read(id, {plane.data(), side * side}); !filled) return filled;
    if (++since_trim % kPlanesBetweenTrims == 0) canvas.trim();
  }
  for (int t = 0; t < canvas.layout().tiles(); ++t)
    if (DetailTile* tile = canvas.find(t))
      tile->open = restore_open_cells(checkpoint, canvas.layout(), t);
  return {};
}

}  // namespace pentimento
