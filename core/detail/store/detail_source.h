#pragma once
// The detail canvas as a CanvasSource, to be shaded, dumped and compared.

#include <atomic>
#include <mutex>
#include <shared_mutex>

#include "core/canvas/canvas_source.h"
#include "core/detail/store/detail_canvas.h"

namespace pentimento {

/// `canvas` and `guide` must outlive the source and must not change while it is read. Depth,
/// pigments, base and reflectance are those of the detail canvas. Velocities are the guide's,
/// interpolated as advect_detail() does. Stroke ids are those of the guide's cells.
class DetailSource final : public CanvasSource {
 public:
  DetailSource(const DetailCanvas& canvas, const CanvasState& guide);

  const CanvasGeometry& geometry() const override { return geometry_; }
  int layers() const override { return canvas_.layers(); }
  int channels() const override { return canvas_.channels(); }
  int bands() const override { return canvas_.bands(); }
  std::int64_t step() const override { return guide_.step; }
  void read(PlaneId plane, int x, int y, std::span<float> out) const override;
  void read_strokes(int x, int y, std::span<std::uint32_t> out) const override;
  bool empty(const CellWindow& window) const override;

 private:
  std::shared_lock<std::shared_mutex> begin_reading() const;
  void release() const;
  void read_tiles(PlaneId plane, int x, int y, std::span<float> out) const;
  void read_velocity(PlaneKind kind, int x, int y, std::span<float> out) const;

  const DetailCanvas& canvas_;
  const CanvasState& guide_;
  CanvasGeometry geometry_;
  // Reading brings tiles back into memory, so after some reads the store is trimmed again.
  mutable std::shared_mutex mutex_;
  mutable std::atomic<std::uint32_t> reads_{0};
};

}  // namespace pentimento
