#pragma once
// The shader's slow twin: one pixel of a picture by the definitions of R29-R35, in double precision
// and with the functions of core/optics. No tables, tiles or textures.

#include <algorithm>
#include <array>
#include <cmath>

#include "core/canvas/canvas_state.h"
#include "core/model/model.h"
#include "core/optics/channels.h"
#include "core/optics/composite.h"
#include "core/optics/gloss_table.h"
#include "core/optics/irradiance.h"
#include "core/optics/kubelka_munk.h"
#include "core/optics/lighting.h"
#include "core/optics/microfacet.h"
#include "core/optics/tone.h"
#include "tests/reference/edge_coverage.h"
#include "tests/reference/gloss.h"
#include "tests/reference/horizon.h"

namespace pentimento::reference {

struct Pixel {
  Rgb picture{}, albedo{}, normal{}, diffuse{}, specular{}, reflection{};
  double height = 0, depth = 0, wet = 0;
};

class ShadingReference {
 public:
  /// `slopes`: as ShadeRequest::relief_samples.
  ShadingReference(const CanvasState& state, const ChannelBasis& basis, const Model& model,
                   const Lighting& lighting, int width, int height, int slopes = 2)
      : s_(state),
        paper_m_(paper_relief_of(state)),
        basis_(basis),
        model_(model),
        light_(lighting),
        width_(width),
        height_(height),
        slopes_(slopes),
        horizon_(state, lighting),
        coverage_(state) {}

  /// By more than it has pixels, and not a whole multiple: cells are shaded, their light averaged.
  bool reduces() const {
    const int w = s_.geometry.width, h = s_.geometry.height;
    return w >= width_ && h >= height_ &&
           (w % width_ != 0 || h % height_ != 0 || w / width_ != h / height_);
  }

  Pixel pixel(int x, int y) const {
    if (!reduces()) return supersampled(x, y);
    const double rx = static_cast<double>(s_.geometry.width) / width_;
    const double ry = static_cast<double>(s_.geometry.height) / height_;
    const auto share = [](int cell, double from, double ratio) {
      return std::max(0.0, std::min(cell + 1.0, from + ratio) - std::max<double>(cell, from)) /
             ratio;
    };
    Pixel sum;
    for (int v = static_cast<int>(y * ry); v < (y + 1) * ry && v < s_.geometry.height; ++v)
      for (int u = static_cast<int>(x * rx); u < (x + 1) * rx && u < s_.geometry.width; ++u)
        add(sum, sample(u, v), share(u, x * rx, rx) * share(v, y * ry, ry));
    return sum;
  }

 private:
  Pixel supersampled(int x, int y) const {
    const int n = std::max({1, (s_.geometry.width + width_ - 1) / width_,
                            (s_.geometry.height + height_ - 1) / height_});
    Pixel sum;
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const double u = (x + (i + 0.5) / n) / width_ * s_.geometry.width - 0.5;
        const double v = (y + (j + 0.5) / n) / height_ * s_.geometry.height - 0.5;
        add(sum, sample(u, v), 1.0 / (n * n));
      }
    }
    return sum;
  }

  static void add(Pixel& sum, const Pixel& p, double weight) {
    for (std::size_t c = 0; c < 3; ++c) {
      sum.picture[c] += weight * p.picture[c];
      sum.albedo[c] += weight * p.albedo[c];
      sum.normal[c] += weight * p.normal[c];
      sum.diffuse[c] += weight * p.diffuse[c];
      sum.specular[c] += weight * p.specular[c];
      sum.reflection[c] += weight * p.reflection[c];
    }
    sum.height += weight * p.height;
    sum.depth += weight * p.depth;
    sum.wet += weight * p.wet;
  }

  double at(const Field<float>& f, int x, int y) const {
    return static_cast<double>(
        f(std::clamp(x, 0, f.width() - 1), std::clamp(y, 0, f.height() - 1)));
  }
  double bilinear(const Field<float>& f, double u, double v) const {
    const int x = static_cast<int>(std::floor(u)), y = static_cast<int>(std::floor(v));
    const double a = u - x, b = v - y;
    return (at(f, x, y) * (1 - a) + at(f, x + 1, y) * a) * (1 - b) +
           (at(f, x, y + 1) * (1 - a) + at(f, x + 1, y + 1) * a) * b;
  }
  double surface(int x, int y) const { return at(s_.base_m, x, y) + at(s_.depth_m, x, y); }

  /// Catmull-Rom through four values, by its Hermite form: ends b, c and slopes of the neighbours.
  static double spline(const std::array<double, 4>& p, double t) {
    const double m0 = (p[2] - p[0]) / 2, m1 = (p[3] - p[1]) / 2;
    const double t2 = t * t, t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * p[1] + (t3 - 2 * t2 + t) * m0 + (3 * t2 - 2 * t3) * p[2] +
           (t3 - t2) * m1;
  }
  double height_at(double u, double v) const {
    const int x = static_cast<int>(std::floor(u)), y = static_cast<int>(std::floor(v));
    std::array<double, 4> column{};
    for (int j = 0; j < 4; ++j) {
      std::array<double, 4> row{};
      for (int i = 0; i < 4; ++i) {
        row[static_cast<std::size_t>(i)] = surface(x + i - 1, y + j - 1);
      }
      column[static_cast<std::size_t>(j)] = spline(row, u - x);
    }
    return spline(column, v - y);
  }
  Rgb normal_at(double u, double v) const {
    // The surface has continuous slopes, so a difference over a small part of a cell finds them.
    const double e = 1e-5, scale = static_cast<double>(light_.relief_scale);
    const double sx = scale * (height_at(u + e, v) - height_at(u - e, v)) / (2 * e) /
                      static_cast<double>(s_.geometry.dx_m());
    const double sy = scale * (height_at(u, v + e) - height_at(u, v - e)) / (2 * e) /
                      static_cast<double>(s_.geometry.dy_m());
    const double length = std::sqrt(sx * sx + sy * sy + 1);
    return {-sx / length, sy / length, 1 / length};
  }

  /// Between the colours of the four cells.
  Rgb albedo_at(double u, double v) const {
    const int x = static_cast<int>(std::floor(u)), y = static_cast<int>(std::floor(v));
    const double a = u - x, b = v - y;
    Rgb out{};
    const auto add = [&](int column, int row, double weight) {
      if (weight == 0) return;
      const Rgb cell = cell_albedo(std::clamp(column, 0, s_.geometry.width - 1),
                                   std::clamp(row, 0, s_.geometry.height - 1));
      for (std::size_t c = 0; c < 3; ++c) out[c] += weight * cell[c];
    };
    add(x, y, (1 - a) * (1 - b));
    add(x + 1, y, a * (1 - b));
    add(x, y + 1, (1 - a) * b);
    add(x + 1, y + 1, a * b);
    return out;
  }
  Rgb cell_albedo(int x, int y) const {
    Rgb out{};
    const double depth = static_cast<double>(s_.depth_m(x, y));
    std::vector<Eigen::VectorXd> layers;
    for (int k = 0; k < s_.layers; ++k) {
      Eigen::VectorXd c(s_.channels);
      for (int i = 0; i < s_.channels; ++i) c(i) = static_cast<double>(s_.channel(k, i)(x, y));
      if (basis_.amount.cast<double>().dot(c) > static_cast<double>(kEmptyLayerAmount)) {
        layers.push_back(c);
      }
    }
    const double coverage = coverage_(x, y);
    for (std::size_t band = 0; band < 3; ++band) {
      const double bare = static_cast<double>(s_.reflectance[band](x, y));
      double R = bare;
      for (const Eigen::VectorXd& c : layers) {
        const double share = depth / static_cast<double>(layers.size()) /
                             static_cast<double>(model_.depth_reference_m) /
                             basis_.amount.cast<double>().dot(c);
        const double f = model_.optical_thickness == OpticalThickness::kDepth
                             ? share / coverage
                             : 1 / static_cast<double>(model_.pigment_reference) / coverage;
        const auto b = static_cast<Eigen::Index>(band);
        R = km_over(km_film({basis_.K.row(b).dot(c) * f, basis_.S.row(b).dot(c) * f}, 1), R);
      }
      out[band] = bare + coverage * (R - bare);
    }
    return out;
  }

  /// The environment, its bands damped as a rough mirror does.
  Rgb blurred(const Rgb& r, double roughness) const {
    ShCoefficients light = light_.environment;
    for (std::size_t i = 1; i < 9; ++i) {
      const double band = i < 4 ? 1 : 2;
      const double damping = std::exp(-band * band * roughness * roughness);
      for (float& v : light.L[i]) v = static_cast<float>(damping * static_cast<double>(v));
    }
    const auto L = sh_radiance(
        light, {static_cast<float>(r[0]), static_cast<float>(r[1]), static_cast<float>(r[2])});
    return {L[0], L[1], L[2]};
  }

  /// The light probe between the two roughnesses that its table has on either side.
  Rgb in_probe(const Rgb& n, double smoothness) const {
    const double dry = static_cast<double>(light_.roughness_dry);
    const double wet = static_cast<double>(light_.roughness_wet);
    const double level = smoothness * (GlossTable::kLevels - 1);
    const double below = std::min(std::floor(level), GlossTable::kLevels - 2.0);
    Rgb out{};
    for (const double k : {below, below + 1}) {
      const double roughness = dry + (wet - dry) * k / (GlossTable::kLevels - 1);
      const Rgb light =
          mean_over_lobe(light_.probe, n, roughness, static_cast<double>(light_.refractive_index));
      for (std::size_t c = 0; c < 3; ++c) out[c] += light[c] * (1 - std::abs(level - k));
    }
    return out;
  }

  Rgb reflected(const Rgb& n, double smoothness, double roughness, double sharp) const {
    const Rgb r = {2 * n[2] * n[0], 2 * n[2] * n[1], 2 * n[2] * n[2] - 1};
    const Rgb around = light_.probe[0].empty() ? blurred(r, roughness) : in_probe(n, smoothness);
    if (light_.reflection.rgb[0].empty()) return around;
    const Rgb seen = in_camera(r);
    Rgb out{};
    for (std::size_t c = 0; c < 3; ++c) out[c] = around[c] + (seen[c] - around[c]) * sharp;
    return out;
  }

  Rgb in_camera(const Rgb& r) const {
    const ReflectionMap& map = light_.reflection;
    const int w = map.rgb[0].width(), h = map.rgb[0].height();
    const double focal =
        0.5 * w / std::tan(static_cast<double>(map.fov_deg) * 3.14159265358979 / 360);
    const double z = std::max(r[2], 1e-3);
    const double u = 0.5 * w + (map.mirror ? -1 : 1) * focal * r[0] / z;
    const double v = 0.5 * h - focal * r[1] / z;
    Rgb out{};
    for (std::size_t c = 0; c < 3; ++c) {
      out[c] = bilinear(map.rgb[c], std::clamp(u - 0.5, 0.0, w - 1.0),
                        std::clamp(v - 0.5, 0.0, h - 1.0));
    }
    return out;
  }

  Pixel sample(double u, double v) const {
    Pixel p;
    p.depth = bilinear(s_.depth_m, u, v);
    p.height = height_at(u, v);
    p.normal = normal_at(u, v);
    p.albedo = albedo_at(u, v);
    const auto covered = [](double film_m) { return 1 - std::exp(-std::max(film_m, 0.0) / 1e-4); };
    p.wet = covered(p.depth);
    const double paint = covered(p.depth + bilinear(s_.base_m, u, v) - bilinear(paper_m_, u, v));
    const auto off_centre = [](double at) { return std::abs(at - std::round(at)) > 1e-6; };
    if (slopes_ == 1 || off_centre(u) || off_centre(v)) {
      light_up(p, paint, u, v);
      return p;
    }
    // On a cell: the mean light of its quarters.
    Pixel sum;
    for (const double down : {-0.25, 0.25}) {
      for (const double right : {-0.25, 0.25}) {
        Pixel quarter = p;
        quarter.normal = normal_at(u + right, v + down);
        light_up(quarter, paint, u, v);
        add(sum, quarter, 0.25);
      }
    }
    const Rgb& n = sum.normal;
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (std::size_t c = 0; c < 3; ++c) sum.normal[c] = n[c] / length;
    return sum;
  }

  void light_up(Pixel& p, double film, double u, double v) const {
    const Rgb& n = p.normal;
    const double varnish = light_.varnish, index = static_cast<double>(light_.refractive_index);
    const double paint = film + (1 - film) * varnish, sharp = p.wet + (1 - p.wet) * varnish;
    const double F = paint * fresnel_schlick(n[2], fresnel_normal(index));
    const auto E = sh_irradiance(
        light_.environment,
        {static_cast<float>(n[0]), static_cast<float>(n[1]), static_cast<float>(n[2])});
    const double flowed = 1 - (1 - varnish) * std::exp(-std::max(p.depth, 0.0) / 4e-4);
    const double roughness = static_cast<double>(light_.roughness_dry) * (1 - flowed) +
                             static_cast<double>(light_.roughness_wet) * flowed;
    const Rgb mirror = reflected(n, flowed, roughness, sharp);
    const double sky = horizon_.sky_seen(u, v);
    for (std::size_t c = 0; c < 3; ++c) {
      const double R = p.albedo[c];
      const double walls =
          ((sky * (2.0404 * R - 0.3324) - 4.7951 * R + 0.6417) * sky + 2.7552 * R + 0.6903) * sky;
      p.diffuse[c] = (1 - F) * R * E[c] / 3.14159265358979 * std::clamp(walls, sky, 1.0);
      p.reflection[c] = F * sky * mirror[c];
    }
    for (const Lamp& lamp : light_.lamps) add_lamp(p, lamp, paint, roughness, F, u, v);
    develop(p);
  }

  void add_lamp(Pixel& p, const Lamp& lamp, double paint, double roughness, double F, double u,
                double v) const {
    const auto [l, share] = lamp_from(lamp, u, v, p.height);
    const double n_l = std::max(p.normal[0] * l[0] + p.normal[1] * l[1] + p.normal[2] * l[2], 0.0);
    const double index = static_cast<double>(light_.refractive_index);
    const double lobe = paint * gloss(p.normal, l, roughness, index) * n_l;
    // Shadows are found at cells' centres, and interpolated like everything else.
    const double seen = horizon_.lamp_seen(
        u, v, [&](int x, int y) { return lamp_from(lamp, x, y, surface(x, y)).first; });
    for (std::size_t c = 0; c < 3; ++c) {
      const double radiance = share * seen * static_cast<double>(lamp.intensity * lamp.color[c]);
      p.diffuse[c] += (1 - F) * p.albedo[c] * radiance * n_l;
      p.specular[c] += 3.14159265358979 * radiance * lobe;
    }
  }

  /// Direction to a lamp from a place among the cells, and its light there against the centre's.
  std::pair<Rgb, double> lamp_from(const Lamp& lamp, double u, double v, double height) const {
    if (!lamp.position_m) {
      return {{lamp.direction[0], lamp.direction[1], lamp.direction[2]}, 1};
    }
    const CanvasGeometry& g = s_.geometry;
    const auto [px, py, pz] = *lamp.position_m;
    const Rgb to = {px - ((u + 0.5) / g.width - 0.5) * g.width_m,
                    py + ((v + 0.5) / g.height - 0.5) * g.height_m, pz - height};
    const double range2 = to[0] * to[0] + to[1] * to[1] + to[2] * to[2];
    const double range = std::sqrt(range2);
    return {{to[0] / range, to[1] / range, to[2] / range},
            static_cast<double>(px * px + py * py + pz * pz) / range2};
  }

  void develop(Pixel& p) const {
    const auto matrix = white_balance(light_.white_xy);
    const double exposure = std::exp2(static_cast<double>(light_.exposure_ev));
    for (Rgb* light : {&p.diffuse, &p.specular, &p.reflection}) {
      const Rgb was = *light;
      for (std::size_t c = 0; c < 3; ++c) {
        (*light)[c] = exposure * (static_cast<double>(matrix[c][0]) * was[0] +
                                  static_cast<double>(matrix[c][1]) * was[1] +
                                  static_cast<double>(matrix[c][2]) * was[2]);
      }
    }
    for (std::size_t c = 0; c < 3; ++c) {
      p.picture[c] = p.diffuse[c] + p.specular[c] + p.reflection[c];
    }
  }

  /// Torrance-Sparrow towards the viewer, lamp and viewer turned into the frame of n.
  double gloss(const Rgb& n, const Rgb& l, double roughness, double index) const {
    const auto in_frame = [&](const Rgb& w) {
      // Two tangents by Gram-Schmidt from x.
      const double k = 1 / std::sqrt(1 - n[0] * n[0]);
      const Rgb t = {k * (1 - n[0] * n[0]), -k * n[0] * n[1], -k * n[0] * n[2]};
      const Rgb b = {n[1] * t[2] - n[2] * t[1], n[2] * t[0] - n[0] * t[2],
                     n[0] * t[1] - n[1] * t[0]};
      const auto dot = [&](const Rgb& a) { return a[0] * w[0] + a[1] * w[1] + a[2] * w[2]; };
      return Rgb{dot(t), dot(b), dot(n)};
    };
    return torrance_sparrow(FacetDistribution::kBeckmann, roughness, index, in_frame(l),
                            in_frame({0, 0, 1}));
  }

  const CanvasState& s_;
  Field<float> paper_m_;
  const ChannelBasis& basis_;
  const Model& model_;
  const Lighting& light_;
  int width_;
  int height_;
  int slopes_;
  HorizonReference horizon_;
  EdgeCoverage coverage_;
};

}  // namespace pentimento::reference
