#include "core/optics/channels.h"

#include <utility>

#include "core/base/check.h"

namespace pentimento {

ChannelBasis palette_channels(const std::vector<Pigment>& palette) {
  PENTIMENTO_CHECK(!palette.empty());
  const Eigen::Index bands = palette.front().K.size();
  const Eigen::Index n = static_cast<Eigen::Index>(palette.size());
  ChannelBasis basis;
  basis.K.resize(bands, n);
  basis.S.resize(bands, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Pigment& p = palette[static_cast<std::size_t>(i)];
    basis.name.push_back(p.name);
    basis.K.col(i) = p.K;
    basis.S.col(i) = p.S;
  }
  basis.amount = Eigen::VectorXf::Ones(n);
  basis.load = Eigen::MatrixXf::Identity(n, n);
  return basis;
}

ChannelBasis optical_channels(const std::vector<Pigment>& palette) {
  PENTIMENTO_CHECK(!palette.empty());
  const Eigen::Index bands = palette.front().K.size();
  const Eigen::Index pigments = static_cast<Eigen::Index>(palette.size());
  const Eigen::Index n = 1 + 2 * bands;
  ChannelBasis basis;
  basis.name.push_back("amount");
  for (Eigen::Index b = 0; b < bands; ++b) basis.name.push_back("K." + std::to_string(b));
  for (Eigen::Index b = 0; b < bands; ++b) basis.name.push_back("S." + std::to_string(b));
  basis.K = Eigen::MatrixXd::Zero(bands, n);
  basis.S = Eigen::MatrixXd::Zero(bands, n);
  basis.K.block(0, 1, bands, bands).setIdentity();
  basis.S.block(0, 1 + bands, bands, bands).setIdentity();
  basis.amount = Eigen::VectorXf::Zero(n);
  basis.amount(0) = 1;
  basis.load.resize(n, pigments);
  for (Eigen::Index i = 0; i < pigments; ++i) {
    const Pigment& p = palette[static_cast<std::size_t>(i)];
    basis.load(0, i) = 1;
    basis.load.col(i).segment(1, bands) = p.K.cast<float>();
    basis.load.col(i).segment(1 + bands, bands) = p.S.cast<float>();
  }
  return basis;
}

ChannelBasis make_channels(const std::vector<Pigment>& palette, std::vector<double> wavelength_nm) {
  PENTIMENTO_CHECK(!palette.empty());
  const int most = most_palette_channels(static_cast<int>(palette.front().K.size()));
  const bool each = static_cast<int>(palette.size()) <= most;
  ChannelBasis basis = each ? palette_channels(palette) : optical_channels(palette);
  basis.wavelength_nm = std::move(wavelength_nm);
  return basis;
}

}  // namespace pentimento
