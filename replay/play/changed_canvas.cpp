#include "replay/play/changed_canvas.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "replay/play/channel_change.h"

namespace pentimento {

namespace {
class ChangedCanvas final : public CanvasSource {
 public:
  ChangedCanvas(std::shared_ptr<const CanvasSource> canvas, Eigen::MatrixXf to)
      : canvas_(std::move(canvas)), to_(std::move(to)) {}

  const CanvasGeometry& geometry() const override { return canvas_->geometry(); }
  int layers() const override { return canvas_->layers(); }
  int channels() const override { return static_cast<int>(to_.rows()); }
  int bands() const override { return canvas_->bands(); }
  std::int64_t step() const override { return canvas_->step(); }
  void read_strokes(int x, int y, std::span<std::uint32_t> out) const override {
    canvas_->read_strokes(x, y, out);
  }
  bool empty(const CellWindow& window) const override { return canvas_->empty(window); }
  void expect(const CellWindow& window, std::span<const PlaneId> planes,
              const Threads& threads) const override {
    // A channel may be made of any that the canvas has in its layer.
    std::vector<PlaneId> read;
    for (const PlaneId& plane : planes) {
      if (plane.kind != PlaneKind::kPigment) read.push_back(plane);
      for (int c = 0; plane.kind == PlaneKind::kPigment && c < to_.cols(); ++c)
        if (to_(plane.index, c) > 0) read.push_back(pigment_plane(plane.layer, c));
    }
    canvas_->expect(window, read, threads);
  }
  Result<void> status() const override { return canvas_->status(); }

  void read(PlaneId plane, int x, int y, std::span<float> out) const override {
    if (plane.kind != PlaneKind::kPigment) return canvas_->read(plane, x, y, out);
    std::fill(out.begin(), out.end(), 0.0f);
    std::vector<float> one(out.size());
    for (int c = 0; c < to_.cols(); ++c) {
      const float weight = to_(plane.index, c);
      if (!(weight > 0)) continue;
      canvas_->read(pigment_plane(plane.layer, c), x, y, one);
      for (std::size_t i = 0; i < out.size(); ++i) out[i] += weight * one[i];
    }
  }

 private:
  std::shared_ptr<const CanvasSource> canvas_;
  Eigen::MatrixXf to_;
};
}  // namespace

std::shared_ptr<const CanvasSource> change_channels(std::shared_ptr<const CanvasSource> canvas,
                                                    const ChannelBasis& old,
                                                    const ChannelBasis& basis) {
  return std::make_shared<ChangedCanvas>(std::move(canvas), channel_conversion(old, basis));
}

DetailCheckpoint change_channels(DetailCheckpoint checkpoint, const StateDump& dump,
                                 const ChannelBasis& basis) {
  const Eigen::MatrixXf to = channel_conversion(dump.basis, basis);
  const int layers = dump.state.layers;
  const auto rows = static_cast<std::size_t>(kCheckpointPigment + layers * dump.basis.channels());
  std::vector<std::uint32_t> table;
  for (std::size_t first = 0; first < checkpoint.tile.size(); first += rows) {
    const std::uint32_t* tile = &checkpoint.tile[first];
    table.insert(table.end(), tile, tile + kCheckpointPigment);
    const std::uint32_t* pigment = tile + kCheckpointPigment;
    for (int layer = 0; layer < layers; ++layer, pigment += to.cols())
      for (int c = 0; c < to.rows(); ++c) {
        std::uint32_t any = 0;
        for (int from = 0; from < to.cols(); ++from) any |= to(c, from) > 0 ? pigment[from] : 0;
        table.push_back(any);
      }
  }
  checkpoint.tile = std::move(table);
  return checkpoint;
}

}  // namespace pentimento
