#pragma once
// A canvas painted by formula, for tests, benchmarks and the eye: linen, a thick blue stroke with
// furrows over a wet red one, a thin yellow glaze, a dried ochre patch. No simulation.

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/canvas/canvas_state.h"
#include "core/optics/channels.h"
#include "core/optics/composite.h"
#include "core/optics/paints/pigment_library.h"

namespace pentimento::painted {

inline std::vector<Pigment> palette() {
  return {*find_library_pigment("ultramarine blue"), *find_library_pigment("cadmium red"),
          *find_library_pigment("hansa yellow"), *find_library_pigment("titanium white")};
}

/// Plain weave: threads over and under, relief 0.3 mm peak to valley.
inline float weave_m(double x_m, double y_m, double pitch_m = 0.0016) {
  const double u = x_m / pitch_m * 3.14159265358979, v = y_m / pitch_m * 3.14159265358979;
  // Two sets of round threads, each rising where the other dives.
  const double rise = 0.3 * std::cos(u) * std::cos(v);
  const double warp = std::abs(std::sin(u)) * (0.7 + rise);
  const double weft = std::abs(std::sin(v)) * (0.7 - rise);
  return static_cast<float>(0.0003 * std::max(warp, weft));
}

/// A stroke along a gentle curve: film thickness across it, with furrows that bristles left.
struct Stroke {
  double x0, y0, x1, y1, bend, width_m, film_m, furrow_frac;
};
inline double stroke_film(const Stroke& s, double x, double y) {
  const double dx = s.x1 - s.x0, dy = s.y1 - s.y0, length = std::sqrt(dx * dx + dy * dy);
  const double t = ((x - s.x0) * dx + (y - s.y0) * dy) / (length * length);
  const double across = ((x - s.x0) * -dy + (y - s.y0) * dx) / length -
                        s.bend * std::sin(3.14159265358979 * std::clamp(t, 0.0, 1.0));
  const double r = across / (0.5 * s.width_m);
  if (t < -0.01 || t > 1.01 || std::abs(r) > 1.05) return 0;
  const double edge = std::clamp((1 - r * r) * 5, 0.0, 1.0);
  const double wander = 0.35 * std::sin(23 * t + 3 * r) + 0.2 * std::sin(51 * t);
  const double furrow = 0.55 * std::sin(34 * r + wander) + 0.3 * std::sin(71 * r + 2 * wander) +
                        0.15 * std::sin(127 * r + 9 * t);
  const double ridge = 0.5 * std::exp(-30 * (std::abs(r) - 0.93) * (std::abs(r) - 0.93));
  return s.film_m * edge * std::max(1 + s.furrow_frac * furrow + ridge - 0.25 * t, 0.02);
}

/// `width` x `height` cells on 0.25 m x 0.25 height / width. Two layers; channels of `basis`, which
/// was made from palette().
inline CanvasState scene(const ChannelBasis& basis, int width, int height) {
  CanvasGeometry geometry{width, height, 0.25, 0.25 * height / width};
  CanvasState s = make_canvas_state(geometry, 2, basis.channels(), 3, 0.9f);
  const double W = geometry.width_m, H = geometry.height_m;
  const Stroke red{.10 * W, .15 * H, .85 * W, .80 * H, .010, .034, .0012, .45};
  const Stroke blue{.12 * W, .80 * H, .88 * W, .22 * H, -.012, .038, .0018, .55};
  const Stroke glaze{.05 * W, .5 * H, .97 * W, .52 * H, 0, .045, .00008, .15};
  const Stroke white{.60 * W, .08 * H, .93 * W, .12 * H, .004, .022, .0016, .6};
  const Stroke ochre{.08 * W, .10 * H, .30 * W, .08 * H, .002, .024, .0010, .5};
  const auto add = [&](int layer, int x, int y, int pigment, double amount) {
    for (int c = 0; c < basis.channels(); ++c) {
      s.channel(layer, c)(x, y) += basis.load(c, pigment) * static_cast<float>(amount);
    }
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double px = (x + .5) * geometry.width_m / width;
      const double py = (y + .5) * geometry.height_m / height;
      const float paper_m = weave_m(px, py);
      const double dried = stroke_film(ochre, px, py);
      s.base_m(x, y) = paper_m + static_cast<float>(dried);
      s.paper.set(x, y, s.base_m(x, y), paper_m);
      const float hiding = static_cast<float>(std::min(dried / .0006, 1.0));
      const float dry_color[] = {.53f, .25f, .03f};
      for (std::size_t band = 0; band < 3; ++band) {
        const float bare = s.reflectance[band](x, y);
        s.reflectance[band].set(x, y, bare + hiding * (dry_color[band] - bare));
      }
      const double r = stroke_film(red, px, py), b = stroke_film(blue, px, py);
      const double g = stroke_film(glaze, px, py), w = stroke_film(white, px, py);
      s.depth_m(x, y) = static_cast<float>(r * (b > 0 ? .4 : 1) + b + g + w);
      add(0, x, y, 1, 30 * r);
      add(1, x, y, 0, 28 * b);
      if (b > 0) add(1, x, y, 1, 4 * r);  // the blue brush picked up some red
      add(1, x, y, 2, 90 * g);
      add(1, x, y, 3, 30 * w);
    }
  }
  return s;
}

}  // namespace pentimento::painted
