#include "core/shading/albedo_row.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/check.h"
#include "core/base/kernel.h"
#include "core/base/row_exp.h"
#include "core/model/model.h"
#include "core/optics/spectral/band_weights.h"

namespace pentimento {
namespace {

/// Cells that are computed together: their sums stay in the nearest cache.
constexpr std::size_t kChunk = 256;
using CellChunk = std::array<float, kChunk>;

PENTIMENTO_KERNEL
void add_scaled(const float* amount, float share, std::size_t n, float* total) {
  PENTIMENTO_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i) total[i] += share * amount[i];
}

PENTIMENTO_KERNEL
void add_paint(const float* amount, float k, float s, std::size_t n, float* K, float* S) {
  PENTIMENTO_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i) {
    K[i] += k * amount[i];
    S[i] += s * amount[i];
  }
}

/// 1 where there is paint, else 0.
PENTIMENTO_KERNEL
void find_paint(const float* total, std::size_t n, float* there) {
  PENTIMENTO_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i) there[i] = total[i] > kEmptyLayerAmount ? 1.0f : 0.0f;
}

/// The factor on K and S of a layer if optical thickness follows the layer's share of the depth.
PENTIMENTO_KERNEL
void share_depth(const float* depth_m, const float* occupied, const float* total,
                 float per_reference, std::size_t n, float* factor) {
  PENTIMENTO_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i) {
    const float film = depth_m[i] / std::max(occupied[i], 1.0f);
    factor[i] = film * per_reference / std::max(total[i], kEmptyLayerAmount);
  }
}

/// A film over R, where there is one.
PENTIMENTO_KERNEL
void lay_film(const float* K, const float* S, const float* factor, const float* there,
              std::size_t n, float* R) {
  PENTIMENTO_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i) {
    const float Kx = std::max(K[i] * factor[i], 0.0f), Sx = std::max(S[i] * factor[i], 0.0f);
    const float z = std::sqrt(std::max(Kx * (Kx + 2 * Sx), 4e-6f));
    const float e = row_exp(std::max(-z, -40.0f)), e2 = e * e, q = 1 - e2;
    const float d = z * (1 + e2) + (Kx + Sx) * q;
    const float s = Sx * q, t = 2 * z * e, ground = R[i];
    const float out = std::max(d - s * ground, 1e-7f * d);
    const float over = (s * out + t * t * ground) / (d * out);
    R[i] = ground + there[i] * (over - ground);
  }
}

/// The dry reflectance where the stack R does not cover the cell.
PENTIMENTO_KERNEL
void leave_bare(const float* dry, const float* coverage, float k2, std::size_t n, float* R) {
  PENTIMENTO_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i) {
    const float laid = partly_covered(dry[i], R[i], coverage[i], k2);
    R[i] = coverage[i] < 1 ? laid : R[i];
  }
}

PENTIMENTO_KERNEL
void add_band(const float* R, float k1, float k2, const float* rgb, std::size_t n, float* red,
              float* green, float* blue) {
  const float through = (1 - k1) * (1 - k2), r = rgb[0], g = rgb[1], b = rgb[2];
  PENTIMENTO_INDEPENDENT
  for (std::size_t i = 0; i < n; ++i) {
    const float inside = std::max(std::min(R[i], 1.0f), 0.0f);
    const float seen = k1 + through * inside / (1 - k2 * inside);
    red[i] += r * seen;
    green[i] += g * seen;
    blue[i] += b * seen;
  }
}

/// One layer of a chunk that has paint somewhere.
struct LayerColor {
  std::size_t first_amount = 0;
  CellChunk factor, there;
};

/// The layers of the chunk that begins at cell x0.
class Layers {
 public:
  Layers(const AlbedoOptics& optics, const AlbedoCells& cells, std::size_t x0, std::size_t n)
      : cells_(cells), x0_(x0), n_(n) {
    const auto channels = static_cast<std::size_t>(optics.paint.amount.size());
    CellChunk occupied;
    occupied.fill(0);
    std::array<CellChunk, kMaxLayers> totals;
    for (std::size_t first = 0; first < cells.amount.size(); first += channels) {
      CellChunk& total = totals[count_];
      total.fill(0);
      for (std::size_t c = 0; c < channels; ++c) {
        const float share = optics.paint.amount(static_cast<Eigen::Index>(c));
        if (share != 0) add_scaled(cells.amount[first + c] + x0, share, n, total.data());
      }
      LayerColor& layer = layers_[count_];
      find_paint(total.data(), n, layer.there.data());
      if (std::find(layer.there.begin(), layer.there.begin() + n, 1.0f) == layer.there.begin() + n)
        continue;
      layer.first_amount = first;
      add_scaled(layer.there.data(), 1, n, occupied.data());
      ++count_;
    }
    const float per_reference = optics.paint.per_reference;
    for (std::size_t k = 0; k < count_; ++k) {
      if (optics.paint.thickness == OpticalThickness::kAmount) {
        layers_[k].factor.fill(per_reference);
      } else {
        share_depth(cells.depth_m.data() + x0, occupied.data(), totals[k].data(), per_reference, n,
                    layers_[k].factor.data());
      }
      for (std::size_t i = 0; i < n && !cells.coverage.empty(); ++i)
        layers_[k].factor[i] /= cells.coverage[x0 + i];
    }
  }

  /// Lays all layers over R, which has the dry reflectance of `band`.
  void lay(const CompositeOptics& paint, Eigen::Index band, float* R) {
    for (std::size_t k = 0; k < count_; ++k) {
      K_.fill(0);
      S_.fill(0);
      for (Eigen::Index c = 0; c < paint.amount.size(); ++c) {
        const float absorbs = paint.K(band, c), scatters = paint.S(band, c);
        if (absorbs == 0 && scatters == 0) continue;  // optical channels are of one band each
        const std::size_t plane = layers_[k].first_amount + static_cast<std::size_t>(c);
        add_paint(cells_.amount[plane] + x0_, absorbs, scatters, n_, K_.data(), S_.data());
      }
      lay_film(K_.data(), S_.data(), layers_[k].factor.data(), layers_[k].there.data(), n_, R);
    }
  }

 private:
  const AlbedoCells& cells_;
  std::size_t x0_, n_;
  std::size_t count_ = 0;
  std::array<LayerColor, kMaxLayers> layers_;
  CellChunk K_, S_;
};

}  // namespace

AlbedoOptics make_albedo_optics(const ChannelBasis& basis, const Model& model) {
  AlbedoOptics out{make_composite_optics(basis, model), Eigen::Matrix3Xf::Identity(3, 3),
                   model.saunderson_k1, model.saunderson_k2};
  if (!basis.wavelength_nm.empty())
    out.rgb = band_rgb_weights(basis.wavelength_nm, model.viewing()).cast<float>();
  return out;
}

void albedo_row(const AlbedoOptics& optics, const AlbedoCells& cells, std::span<float> texels) {
  const std::size_t width = cells.depth_m.size();
  const auto channels = static_cast<std::size_t>(optics.paint.amount.size());
  PENTIMENTO_CHECK(texels.size() == 4 * width &&
                   cells.amount.size() <= static_cast<std::size_t>(kMaxLayers) * channels);
  PENTIMENTO_CHECK(cells.coverage.empty() || cells.coverage.size() == width);
  PENTIMENTO_CHECK(static_cast<Eigen::Index>(cells.dry.size()) == optics.rgb.cols());
  CellChunk R, red, green, blue;
  for (std::size_t x0 = 0; x0 < width; x0 += kChunk) {
    const std::size_t n = std::min(kChunk, width - x0);
    Layers layers(optics, cells, x0, n);
    red.fill(0);
    green.fill(0);
    blue.fill(0);
    for (std::size_t band = 0; band < cells.dry.size(); ++band) {
      const auto b = static_cast<Eigen::Index>(band);
      std::copy_n(cells.dry[band] + x0, n, R.begin());
      layers.lay(optics.paint, b, R.data());
      if (!cells.coverage.empty())
        leave_bare(cells.dry[band] + x0, cells.coverage.data() + x0, optics.k2, n, R.data());
      add_band(R.data(), optics.k1, optics.k2, optics.rgb.col(b).data(), n, red.data(),
               green.data(), blue.data());
    }
    float* out = texels.data() + 4 * x0;
    const float* depth = cells.depth_m.data() + x0;
    for (std::size_t i = 0; i < n; ++i, out += 4) {
      out[0] = red[i];
      out[1] = green[i];
      out[2] = blue[i];
      out[3] = depth[i];
    }
  }
}

}  // namespace pentimento
