#pragma once
// A guide with its detail canvas, painted by a few crossing strokes; and what a block holds.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

#include "core/brush/builtin_brushes.h"
#include "core/brush/stroke_path.h"
#include "core/detail/detail_follower.h"
#include "core/simulation/simulation.h"
#include "tests/core/three_pigments.h"

namespace pentimento::test {

/// Smooth white paper.
class PlainSubstrate : public DetailSubstrate {
 public:
  void relief_row(int, int, std::span<float> out) const override {
    for (float& h : out) h = 0;
  }
  void reflectance_row(int, int, int, std::span<float> out) const override {
    for (float& r : out) r = 0.9f;
  }
};

class Painted {
 public:
  Painted(int width, int factor, int thread_count = 1, bool locked = true)
      : Painted(width, factor, Threads(thread_count), locked, {}) {}

  /// The tiles live in `where`, whatever its blocks' size.
  Painted(int width, int factor, Threads threads, bool locked, TileStoreOptions where)
      : threads_(std::move(threads)), sim_(setup_of(width), threads_) {
    const CanvasState& state = sim_.state();
    const auto side = static_cast<std::size_t>(DetailLayout(state.geometry, factor).side());
    where.buffer_floats = side * side;
    store_ = std::move(*TileStore::open(where));
    follower_ = std::make_unique<DetailFollower>(
        DetailFollowerSetup{
            state.geometry, factor, state.layers, state.channels, state.bands,
            std::vector<float>(sim_.basis().amount.begin(), sim_.basis().amount.end()), locked},
        substrate_, *store_, threads_);
    sim_.set_listener(follower_.get());
  }

  Simulation& sim() { return sim_; }
  const DetailFollower& follower() const { return *follower_; }
  DetailFollower& follower() { return *follower_; }
  const TileStore& store() const { return *store_; }

  /// A stroke, 0.6 s long, with steps in between.
  void stroke(int color, double x0, double y0, double x1, double y1, float diameter_m = 0.02f) {
    sim_.set_color(color);
    sim_.begin_stroke(0, ++stroke_);
    StrokePath path(0.025, 0.2, 0.15);
    std::vector<Stamp> stamps;
    for (int i = 0; i <= 12; ++i) {
      TouchSample s;
      s.x_m = x0 + (x1 - x0) * i / 12;
      s.y_m = y0 + (y1 - y0) * i / 12 + 0.004 * ((i * 7) % 3);
      s.time_s = 0.05 * i;
      s.diameter_m = diameter_m;
      if (i == 0) {
        path.begin(s);
      } else {
        path.add(s, stamps);
      }
      for (const Stamp& stamp : stamps) sim_.stamp(0, stamp);
      stamps.clear();
      sim_.step();
      sim_.step();
    }
    path.finish(stamps);
    for (const Stamp& stamp : stamps) sim_.stamp(0, stamp);
    sim_.end_stroke(0);
    sim_.step();
  }

  /// A touch at one place, with no step after it.
  void stamp_once(double x, double y) {
    sim_.begin_stroke(0, ++stroke_);
    StrokePath path(0.025, 0.2, 0.15);
    std::vector<Stamp> stamps;
    TouchSample s;
    s.x_m = x;
    s.y_m = y;
    s.diameter_m = 0.02f;
    path.begin(s);
    path.finish(stamps);
    for (const Stamp& stamp : stamps) sim_.stamp(0, stamp);
    sim_.end_stroke(0);
  }

  /// Becomes what `other` is, by what a dump of it has.
  void go_on_from(const Painted& other, CanvasState state, const CanvasSource& fine,
                  const DetailCheckpoint& checkpoint) {
    sim_.restore(std::move(state));
    follower_->resume(fine, checkpoint, sim_.state());
    stroke_ = other.stroke_;
  }

  void cross() {
    stroke(0, 0.03, 0.04, 0.17, 0.1);
    stroke(1, 0.03, 0.1, 0.17, 0.04);
    stroke(2, 0.1, 0.02, 0.09, 0.13, 0.03f);
  }

  /// Strokes that dry, under a stroke that stays wet.
  void cross_and_dry() {
    cross();
    sim_.dry();
    stroke(1, 0.02, 0.02, 0.1, 0.12);
  }

 private:
  static SimulationSetup setup_of(int width) {
    SimulationSetup setup;
    setup.geometry = {width, width * 3 / 4, 0.2, 0.15};
    setup.basis = palette_channels(three_pigments());
    return setup;
  }

  Threads threads_;
  PlainSubstrate substrate_;
  Simulation sim_;
  std::unique_ptr<TileStore> store_;
  std::unique_ptr<DetailFollower> follower_;
  std::uint32_t stroke_ = 0;
};

inline bool same_plane(const TilePlane& a, const TilePlane& b, int side) {
  if (static_cast<bool>(a) != static_cast<bool>(b)) return false;
  return !a || std::memcmp(a.data(), b.data(),
                           static_cast<std::size_t>(side) * static_cast<std::size_t>(side) *
                               sizeof(float)) == 0;
}

/// Whether both have the same planes with the same bits.
inline bool same_tiles(const DetailCanvas& a, const DetailCanvas& b) {
  const int side = a.layout().side();
  const auto same = [&](const TilePlane& p, const TilePlane& q) { return same_plane(p, q, side); };
  for (int t = 0; t < a.layout().tiles(); ++t) {
    const DetailTile *p = a.find(t), *q = b.find(t);
    if ((p == nullptr) != (q == nullptr)) return false;
    if (p == nullptr) continue;
    if (!same(p->depth_m, q->depth_m) || !same(p->base_m, q->base_m) ||
        !std::equal(p->pigment.begin(), p->pigment.end(), q->pigment.begin(), q->pigment.end(),
                    same) ||
        !std::equal(p->reflectance.begin(), p->reflectance.end(), q->reflectance.begin(),
                    q->reflectance.end(), same) ||
        p->open.opened != q->open.opened || p->open.mismatched != q->open.mismatched)
      return false;
  }
  return true;
}

/// Mean of the fine cells of a guide cell.
inline double block_mean(const DetailCanvas& canvas, const WetPlane& q, int x, int y) {
  const DetailLayout& layout = canvas.layout();
  const int k = layout.factor(), blocks = layout.blocks();
  const DetailTile* tile = canvas.find(layout.tile_of(x / blocks, y / blocks));
  if (tile == nullptr) return 0;
  const TilePlane& plane =
      q.pigment < 0 ? tile->depth_m : tile->pigment[static_cast<std::size_t>(q.pigment)];
  if (!plane) return 0;
  double sum = 0;
  for (int j = 0; j < k; ++j)
    for (int i = 0; i < k; ++i)
      sum += static_cast<double>(
          plane.data()[(y % blocks * k + j) * layout.side() + x % blocks * k + i]);
  return sum / (k * k);
}

/// How far the detail, reduced, is from the guide.
struct Difference {
  double relative_l2 = 0;  // the L2 norm itself where the guide has nothing
  double psnr_db = 0;      // of the largest value that the guide has
  double worst_block = 0;  // the largest difference relative to what the guide's cell has
};

/// Of the depth (-1) or a channel, summed over its layers.
inline Difference reduced_difference(const DetailCanvas& canvas, const CanvasState& guide,
                                     int channel) {
  std::vector<WetPlane> planes;
  for (int layer = 0; layer < guide.layers; ++layer)
    planes.push_back(WetPlane{layer * guide.channels + channel});
  if (channel < 0) planes = {WetPlane{}};
  double difference = 0, size = 0, largest = 0, worst = 0;
  for (int y = 0; y < guide.geometry.height; ++y) {
    for (int x = 0; x < guide.geometry.width; ++x) {
      double wanted = 0, held = 0;
      for (const WetPlane& q : planes) {
        wanted += static_cast<double>(q.of(guide)(x, y));
        held += block_mean(canvas, q, x, y);
      }
      difference += (held - wanted) * (held - wanted);
      size += wanted * wanted;
      largest = std::max(largest, wanted);
      if (wanted > 0) worst = std::max(worst, std::abs(held - wanted) / wanted);
    }
  }
  const double cells = static_cast<double>(guide.geometry.width) * guide.geometry.height;
  return {size > 0 ? std::sqrt(difference / size) : std::sqrt(difference),
          10 * std::log10(largest * largest * cells / difference), worst};
}

}  // namespace pentimento::test
