#include "core/detail/flow/level_detail.h"

#include <algorithm>
#include <cmath>

#include "core/detail/flow/film_spline.h"
#include "core/detail/flow/level_rows.h"
#include "core/detail/flow/smooth_field.h"
#include "core/fluid/rheology.h"

namespace pentimento {

namespace {
constexpr float kRipple_per_m2 = 4e7f;  // squared wave number of ripples of a millimetre
constexpr float kLeastRate = 1e-3f;     // levelling slower than this is never seen
constexpr int kReach = TileNeighbourhood::kMargin;  // cells around that levelling looks at
constexpr int kBeside = kLevellingRadius - kReach;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// Levels tile by tile. The buffers are kept from tile to tile.
class TileLeveller {
 public:
  TileLeveller(DetailCanvas& canvas, const CanvasState& guide, const PaintEdges& edges,
               const StepInput& in)
      : canvas_(canvas),
        guide_(guide),
        edges_(edges),
        in_(in),
        rheology_(make_rheology(in.model)),
        gravity_m_s2_(std::sqrt(in.gravity_m_s2.x * in.gravity_m_s2.x +
                                in.gravity_m_s2.y * in.gravity_m_s2.y +
                                in.gravity_m_s2.z * in.gravity_m_s2.z)) {}

  void level(DetailTile& tile) {
    if (!tile.depth_m || !tile.base_m) return;
    // How fast each cell of the guide levels; only boxes around those that do are worked on.
    TileNeighbourhood rates(tile.box, guide_.geometry.width, guide_.geometry.height);
    rates.fill([&](int x, int y) { return rate_at(x, y); });
    for (const CellBox& box : boxes_that_level(tile, rates)) level_box(tile, rates, box);
  }

 private:
  bool moves(int x, int y) const {
    const Field<float>&along_x = edges_.x[0], &along_y = edges_.y[0];
    return along_x(x, y) != 0 || along_y(x, y) != 0 || (x > 0 && along_x(x - 1, y) != 0) ||
           (y > 0 && along_y(x, y - 1) != 0);
  }

  /// Whether paint moves in a cell or beside it. An edge that is held does not move, but tension
  /// smooths it while paint arrives behind it.
  bool moves_beside(int x, int y) const {
    const int right = guide_.geometry.width - 1, bottom = guide_.geometry.height - 1;
    for (int j = std::max(0, y - kBeside); j <= std::min(bottom, y + kBeside); ++j)
      for (int i = std::max(0, x - kBeside); i <= std::min(right, x + kBeside); ++i)
        if (moves(i, j)) return true;
    return false;
  }

  /// L of a cell of the guide (level_detail.h).
  float rate_at(int x, int y) const {
    const float depth = guide_.depth_m(x, y);
    if (!(depth > 0) || !moves_beside(x, y)) return 0;
    // The paint's rheology, as the guide has it.
    float amount = 0;
    for (int layer = 0; layer < guide_.layers; ++layer)
      for (int c = 0; c < guide_.channels; ++c)
        if (in_.amount[at(c)] != 0) amount += in_.amount[at(c)] * guide_.channel(layer, c)(x, y);
    float mobility = 0, viscosity = 0;
    rheology_row(rheology_, 0.0f, {&depth, 1}, {&amount, 1}, {&mobility, 1}, {&viscosity, 1});
    const float nu = std::max(viscosity, in_.model.friction_viscosity_floor_m2_s);
    // The rate of the ripples' decay, and the share of them that goes in this step.
    const float rate =
        in_.dt_s * gravity_m_s2_ * mobility * depth * depth * depth / (3 * nu) * kRipple_per_m2;
    const float share = rate / (1 + rate);
    return share > kLeastRate ? share : 0.0f;
  }

  /// Boxes of blocks with something that levels in or around them. Boxes have no column in common:
  /// drips that are far apart are levelled each by itself.
  std::vector<CellBox> boxes_that_level(const DetailTile& tile, const TileNeighbourhood& rates) {
    std::vector<CellBox> boxes;
    const CellBox& all = tile.box;
    for (int x = all.x0 - kReach; x < all.x1 + kReach; ++x)
      for (int y = all.y0 - kReach; y < all.y1 + kReach; ++y) {
        if (rates.at(x, y) == 0) continue;
        const CellBox around = {std::max(x - kReach, all.x0), std::min(x + kReach + 1, all.x1),
                                std::max(y - kReach, all.y0), std::min(y + kReach + 1, all.y1)};
        if (boxes.empty() || boxes.back().x1 <= around.x0) boxes.push_back(around);
        CellBox& box = boxes.back();
        box = {std::min(box.x0, around.x0), std::max(box.x1, around.x1),
               std::min(box.y0, around.y0), std::max(box.y1, around.y1)};
      }
    return boxes;
  }

  void level_box(DetailTile& tile, const TileNeighbourhood& rates, const CellBox& box) {
    box_ = box;
    // How fast each fine cell levels.
    smooth([&](int x, int y) { return rates.at(x, y); }, rate_);
    spare_dry_blocks();
    // What it levels to: the guide's film as a smooth surface, with a smooth edge.
    const FilmSpline spline(guide_.depth_m, box);
    smooth([&](int x, int y) { return spline.coverage(x, y); }, wet_);
    smooth([&](int x, int y) { return spline.film(x, y); }, depth_);
    smooth([&](int x, int y) { return guide_.depth_m(x, y); }, plain_depth_);
    smooth([&](int x, int y) { return guide_.base_m(x, y); }, base_);
    // The depth relaxes to that, row by row; the pigment follows.
    before_.resize(rate_.size());
    for (int row = 0; row < rows(); ++row) {
      float* depth = tile.depth_m.data() + in_tile(tile, row);
      std::copy_n(depth, cells(), before_.begin() + row * cells());
      relax_depth_row(fields(row), tile.base_m.data() + in_tile(tile, row), cells(), depth);
    }
    for (std::size_t p = 0; p < tile.pigment.size(); ++p)
      if (tile.pigment[p]) carry(tile, p, spline);
  }

  int cells() const { return box_.width() * canvas_.layout().factor(); }
  int rows() const { return box_.height() * canvas_.layout().factor(); }
  /// Index in a plane of the tile where a row of the box starts.
  std::ptrdiff_t in_tile(const DetailTile& tile, int row) const {
    const int k = canvas_.layout().factor(), side = canvas_.layout().side();
    return static_cast<std::ptrdiff_t>((box_.y0 - tile.box.y0) * k + row) * side +
           (box_.x0 - tile.box.x0) * k;
  }
  LevelRow fields(int row) const {
    const std::size_t i = at(row) * at(cells());
    return {&rate_[i], &wet_[i], &depth_[i], &base_[i]};
  }

  template <typename ValueAt>
  void smooth(const ValueAt& value_at, std::vector<float>& out) {
    TileNeighbourhood values(box_, guide_.geometry.width, guide_.geometry.height);
    values.fill(value_at);
    out.resize(at(cells()) * at(rows()));
    values.smooth(canvas_.layout().factor(), out.data(), cells());
  }

  /// Blocks that are dry on the guide do not level.
  void spare_dry_blocks() {
    const int k = canvas_.layout().factor();
    for (int row = 0; row < rows(); ++row)
      for (int x = 0; x < box_.width(); ++x)
        if (!(guide_.depth_m(box_.x0 + x, box_.y0 + row / k) > 0))
          std::fill_n(rate_.begin() + row * cells() + x * k, k, 0.0f);
  }

  /// Pigment goes with the depth that came or went. Near the pigment's own edge it relaxes as depth
  /// does.
  void carry(DetailTile& tile, std::size_t plane, const FilmSpline& film) {
    const Field<float>& amount = guide_.pigment[plane];
    smooth([&](int x, int y) { return amount(x, y); }, amount_);
    const FilmSpline spline(amount, film);
    smooth([&](int x, int y) { return spline.coverage(x, y); }, stain_);
    for (int row = 0; row < rows(); ++row) {
      const std::size_t i = at(row) * at(cells());
      const std::ptrdiff_t first = in_tile(tile, row);
      relax_pigment_row(fields(row), {&amount_[i], &plain_depth_[i], &stain_[i]}, &before_[i],
                        tile.depth_m.data() + first, cells(), tile.pigment[plane].data() + first);
    }
  }

  DetailCanvas& canvas_;
  const CanvasState& guide_;
  const PaintEdges& edges_;
  const StepInput& in_;
  Rheology rheology_;
  float gravity_m_s2_;
  CellBox box_;  // the box that is being levelled
  std::vector<float> rate_, wet_, depth_, plain_depth_, base_, before_, amount_, stain_;
};
}  // namespace

void level_detail(DetailCanvas& canvas, const CanvasState& guide, const PaintEdges& edges,
                  const StepInput& in, const ChangedBlocks& moving) {
  const std::vector<int> tiles = moving.tiles();
  in.threads.for_ranges(0, static_cast<int>(tiles.size()), 1, [&](int begin, int end) {
    TileLeveller leveller(canvas, guide, edges, in);
    for (int t = begin; t < end; ++t)
      if (DetailTile* tile = canvas.find(tiles[at(t)])) leveller.level(*tile);
  });
}

}  // namespace pentimento
