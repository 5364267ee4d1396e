#include "core/detail/level_detail.h"

#include <algorithm>
#include <cmath>

#include "core/detail/smooth_field.h"
#include "core/fluid/rheology.h"

namespace pentimento {

namespace {
constexpr float kRipple_per_m2 = 4e7f;  // squared wave number of ripples of a millimetre
constexpr float kEdgeLow = 0.35f, kEdgeHigh = 0.75f;
constexpr float kEdgeReach = 4;  // pigment is relaxed where its wetness is below 1, fully at 3/4
constexpr float kBare = 0.02f;   // of the fullest around: less is no film
constexpr float kLeastRate = 1e-3f;  // slower levelling shows in no session

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// m of the edge, with a skirt so faint that it shows only where a block has nothing else.
float edge_profile(float wetness) {
  constexpr float kSkirt = 0.02f;
  const float t = std::clamp((wetness - kEdgeLow) / (kEdgeHigh - kEdgeLow), 0.0f, 1.0f);
  return std::max(t * t * (3 - 2 * t), kSkirt * wetness * wetness * wetness);
}

/// Levels one tile; keeps its buffers.
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
    if (!tile.depth_m || !tile.base_m || !find_rates(tile)) return;
    const std::size_t cells = at(canvas_.layout().side()) * at(canvas_.layout().side());
    for (std::vector<float>* v : {&rate_, &wet_, &depth_, &base_, &old_}) v->resize(cells);
    smooth(
        tile, [&](int x, int y) { return fill_at(guide_.depth_m, x, y); }, wet_);
    smooth(
        tile, [&](int x, int y) { return guide_.depth_m(x, y); }, depth_);
    smooth(
        tile, [&](int x, int y) { return guide_.base_m(x, y); }, base_);
    std::copy_n(tile.depth_m.data(), cells, old_.data());
    for_wet_cells(tile, [&](std::size_t i) { level_cell(tile, i); });
    for (std::size_t p = 0; p < tile.pigment.size(); ++p)
      if (tile.pigment[p]) carry(tile, static_cast<int>(p));
  }

 private:
  bool moves(int x, int y) const {
    const Field<float>&along_x = edges_.x[0], &along_y = edges_.y[0];
    return along_x(x, y) != 0 || along_y(x, y) != 0 || (x > 0 && along_x(x - 1, y) != 0) ||
           (y > 0 && along_y(x, y - 1) != 0);
  }

  /// L of the guide's cell.
  float rate_at(int x, int y) const {
    const float depth = guide_.depth_m(x, y);
    if (!(depth > 0) || !moves(x, y)) return 0;
    float amount = 0;
    for (int layer = 0; layer < guide_.layers; ++layer)
      for (int c = 0; c < guide_.channels; ++c)
        if (in_.amount[at(c)] != 0) amount += in_.amount[at(c)] * guide_.channel(layer, c)(x, y);
    float mobility = 0, viscosity = 0;
    rheology_row(rheology_, 0.0f, {&depth, 1}, {&amount, 1}, {&mobility, 1}, {&viscosity, 1});
    const float nu = std::max(viscosity, in_.model.friction_viscosity_floor_m2_s);
    const float rate =
        in_.dt_s * gravity_m_s2_ * mobility * depth * depth * depth / (3 * nu) * kRipple_per_m2;
    return rate / (1 + rate);
  }

  bool find_rates(const DetailTile& tile) {
    TileNeighbourhood rates(tile.box, guide_.geometry.width, guide_.geometry.height);
    bool any = false;
    rates.fill([&](int x, int y) {
      const float rate = rate_at(x, y);
      any |= rate > kLeastRate;
      return rate;
    });
    if (!any) return false;
    rate_.resize(at(canvas_.layout().side()) * at(canvas_.layout().side()));
    rates.smooth(canvas_.layout().factor(), rate_.data(), canvas_.layout().side());
    return true;
  }

  template <typename ValueAt>
  void smooth(const DetailTile& tile, const ValueAt& value_at, std::vector<float>& out) {
    TileNeighbourhood values(tile.box, guide_.geometry.width, guide_.geometry.height);
    values.fill(value_at);
    values.smooth(canvas_.layout().factor(), out.data(), canvas_.layout().side());
  }

  /// How full the guide's cell is: 1, beside bare cells its share of the fullest around.
  static float fill_at(const Field<float>& plane, int x, int y) {
    const float here = plane(x, y);
    if (!(here > 0)) return 0;
    float most = here, least = here;
    for (int j = std::max(0, y - 1); j <= std::min(plane.height() - 1, y + 1); ++j)
      for (int i = std::max(0, x - 1); i <= std::min(plane.width() - 1, x + 1); ++i)
        most = std::max(most, plane(i, j)), least = std::min(least, plane(i, j));
    return least < kBare * most ? here / most : 1.0f;
  }

  /// Calls body(index) for the fine cells in blocks where the guide is wet.
  template <typename Body>
  void for_wet_cells(const DetailTile& tile, const Body& body) const {
    const int k = canvas_.layout().factor(), side = canvas_.layout().side();
    for (int y = 0; y < tile.box.height() * k; ++y)
      for (int x = 0; x < tile.box.width() * k; ++x)
        if (guide_.depth_m(tile.box.x0 + x / k, tile.box.y0 + y / k) > 0)
          body(at(y) * at(side) + at(x));
  }

  void level_cell(DetailTile& tile, std::size_t i) {
    const float wet = wet_[i];
    const float film = wet > 0 ? depth_[i] / wet : 0.0f;
    const float target =
        edge_profile(wet) * std::max(0.0f, film + base_[i] - tile.base_m.data()[i]);
    tile.depth_m.data()[i] += rate_[i] * (target - old_[i]);
  }

  /// Pigment goes with the depth that came or went; near its own edge it relaxes as depth does.
  void carry(DetailTile& tile, int plane) {
    for (std::vector<float>* v : {&amount_, &stain_}) v->resize(old_.size());
    const Field<float>& amount = guide_.pigment[at(plane)];
    smooth(
        tile, [&](int x, int y) { return amount(x, y); }, amount_);
    smooth(
        tile, [&](int x, int y) { return fill_at(amount, x, y); }, stain_);
    float* pigment = tile.pigment[at(plane)].data();
    const float* depth = tile.depth_m.data();
    for_wet_cells(tile, [&](std::size_t i) {
      const float gained = depth[i] - old_[i];
      if (gained < 0) {
        pigment[i] *= depth[i] / old_[i];
      } else if (depth_[i] > 0) {
        pigment[i] += gained * amount_[i] / depth_[i];
      }
      const float edge = std::min(1.0f, kEdgeReach * (1 - stain_[i]));
      if (stain_[i] > 0 && edge > 0) {
        const float target = edge_profile(stain_[i]) * amount_[i] / stain_[i];
        pigment[i] += rate_[i] * edge * (target - pigment[i]);
      }
    });
  }

  DetailCanvas& canvas_;
  const CanvasState& guide_;
  const PaintEdges& edges_;
  const StepInput& in_;
  Rheology rheology_;
  float gravity_m_s2_;
  std::vector<float> rate_, wet_, depth_, base_, old_, amount_, stain_;
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
