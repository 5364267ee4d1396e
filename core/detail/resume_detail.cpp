#include "core/detail/resume_detail.h"

#include "core/base/check.h"

namespace pentimento {

namespace {
constexpr int kTilesBetweenTrims = 64;

class Resumption {
 public:
  Resumption(DetailCanvas& canvas, const CanvasSource& fine, const DetailCheckpoint& checkpoint)
      : canvas_(canvas),
        fine_(fine),
        checkpoint_(checkpoint),
        columns_(kCheckpointPigment + canvas.layers() * canvas.channels()) {}

  /// Of all tiles, one plane: what is read one after the other lies side by side in the file.
  template <typename WantsPlane, typename PlaneOf>
  void read_plane(PlaneId id, const WantsPlane& wants, const PlaneOf& plane_of) {
    for (int t = 0; t < canvas_.layout().tiles(); ++t) {
      if (wants(t)) read(id, canvas_.at(t), plane_of(canvas_.at(t)));
      if (t % kTilesBetweenTrims == 0) canvas_.trim();
    }
  }

  bool noted(int tile, int column) const {
    return checkpoint_.tile[static_cast<std::size_t>(tile) * static_cast<std::size_t>(columns_) +
                            static_cast<std::size_t>(column)] != 0;
  }

 private:
  void read(PlaneId id, const DetailTile& tile, TilePlane& plane) {
    if (!plane && !canvas_.make(plane)) return;
    plane.mark_used();
    const int side = canvas_.layout().side(), k = canvas_.layout().factor();
    for (int y = 0; y < tile.box.height() * k; ++y)
      fine_.read(id, tile.box.x0 * k, tile.box.y0 * k + y,
                 {plane.data() + static_cast<std::ptrdiff_t>(y) * side,
                  static_cast<std::size_t>(tile.box.width() * k)});
  }

  DetailCanvas& canvas_;
  const CanvasSource& fine_;
  const DetailCheckpoint& checkpoint_;
  int columns_;
};

/// Whether the guide shows something else than the ground: a picture that was loaded, which the
/// ground does not remember.
bool hides_ground(const DetailCanvas& canvas, const CanvasState& guide, int tile) {
  const CellBox box = canvas.layout().box(tile);
  const int k = canvas.layout().factor();
  std::vector<float> substrate(static_cast<std::size_t>(box.width() * k));
  for (int band = 0; band < canvas.bands(); ++band)
    for (int y = box.y0; y < box.y1; ++y) {
      canvas.substrate().reflectance_row(band, box.x0 * k, y * k, substrate);
      for (int x = box.x0; x < box.x1; ++x)
        if (guide.reflectance[static_cast<std::size_t>(band)](x, y) !=
            substrate[static_cast<std::size_t>((x - box.x0) * k)])
          return true;
    }
  return false;
}
}  // namespace

void resume_detail(DetailCanvas& canvas, const CanvasSource& fine,
                   const DetailCheckpoint& checkpoint, const CanvasState& guide) {
  PENTIMENTO_CHECK(fine.channels() == canvas.channels() && fine.layers() == canvas.layers());
  const DetailLayout& layout = canvas.layout();
  Resumption from(canvas, fine, checkpoint);
  const auto noted = [&](int column) {
    return [&from, column](int tile) { return from.noted(tile, column); };
  };
  from.read_plane({PlaneKind::kBase}, noted(kCheckpointMade),
                  [](DetailTile& tile) -> TilePlane& { return tile.base_m; });
  for (int p = -1; p < canvas.layers() * canvas.channels(); ++p)
    from.read_plane(p < 0 ? PlaneId{PlaneKind::kDepth}
                          : pigment_plane(p / canvas.channels(), p % canvas.channels()),
                    noted(kCheckpointPigment + p),
                    [p](DetailTile& tile) -> TilePlane& { return WetPlane{p}.of(tile); });
  std::vector<bool> reflects(static_cast<std::size_t>(layout.tiles()));
  for (int t = 0; t < layout.tiles(); ++t)
    reflects[static_cast<std::size_t>(t)] =
        from.noted(t, kCheckpointDried) || hides_ground(canvas, guide, t);
  for (int band = 0; band < canvas.bands(); ++band)
    from.read_plane(
        reflectance_plane(band), [&](int t) { return reflects[static_cast<std::size_t>(t)]; },
        [&](DetailTile& tile) -> TilePlane& {
          tile.reflectance.resize(static_cast<std::size_t>(canvas.bands()));
          return tile.reflectance[static_cast<std::size_t>(band)];
        });
  for (int t = 0; t < layout.tiles(); ++t)
    if (DetailTile* tile = canvas.find(t)) tile->open = restore_open_cells(checkpoint, layout, t);
}

}  // namespace pentimento
