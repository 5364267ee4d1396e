#include "replay/play/channel_change.h"

#include <algorithm>
#include <utility>

namespace pentimento {

bool channel_per_pigment(const ChannelBasis& basis) {
  return basis.load.rows() == basis.load.cols() && basis.load.isIdentity(0);
}

namespace {
bool same_paint(const Pigment& a, const Pigment& b) {
  return a.K.size() == b.K.size() && a.K == b.K && a.S == b.S;
}

Field<float> weighted_sum(const CanvasState& state, int layer, const Eigen::RowVectorXf& weight) {
  Field<float> sum(state.geometry.width, state.geometry.height);
  for (int c = 0; c < state.channels; ++c) {
    const float w = weight(c);
    if (!(w > 0)) continue;
    const Field<float>& plane = state.channel(layer, c);
    for (int y = 0; y < sum.height(); ++y) {
      for (int x = 0; x < sum.width(); ++x) sum(x, y) += w * plane(x, y);
    }
  }
  return sum;
}
}  // namespace

Result<std::vector<Pigment>> join_palettes(const std::vector<Pigment>& first,
                                           const std::vector<Pigment>& second) {
  std::vector<Pigment> joined = first;
  for (const Pigment& pigment : second) {
    const auto known = std::find_if(first.begin(), first.end(),
                                    [&](const Pigment& p) { return p.name == pigment.name; });
    if (known == first.end()) {
      joined.push_back(pigment);
    } else if (!same_paint(*known, pigment)) {
      return Error{ErrorCode::kBadInput, "the pigment \"" + pigment.name +
                                             "\" is another paint in the dump than in the log"};
    }
  }
  return joined;
}

ChannelBasis channels_after(const ChannelBasis& old, const std::vector<Pigment>& palette) {
  if (channel_per_pigment(old)) return make_channels(palette, old.wavelength_nm);
  ChannelBasis basis = optical_channels(palette);
  basis.wavelength_nm = old.wavelength_nm;
  return basis;
}

Eigen::MatrixXf channel_conversion(const ChannelBasis& old, const ChannelBasis& basis) {
  Eigen::MatrixXf to = Eigen::MatrixXf::Zero(basis.channels(), old.channels());
  if (channel_per_pigment(basis)) {
    to.topLeftCorner(old.channels(), old.channels()).setIdentity();
  } else if (channel_per_pigment(old)) {
    to = basis.load.leftCols(old.channels());
  } else {
    to.setIdentity();
  }
  return to;
}

CanvasState change_channels(CanvasState state, const ChannelBasis& old, const ChannelBasis& basis) {
  const Eigen::MatrixXf to = channel_conversion(old, basis);
  std::vector<Field<float>> pigment;
  for (int layer = 0; layer < state.layers; ++layer) {
    for (int c = 0; c < basis.channels(); ++c) {
      pigment.push_back(weighted_sum(state, layer, to.row(c)));
    }
  }
  state.pigment = std::move(pigment);
  state.channels = basis.channels();
  // Paint with amounts in other units may not rest where the old paint rested, so everything wakes.
  if (channel_per_pigment(old) && !channel_per_pigment(basis)) state.sleep.clear();
  return state;
}

}  // namespace pentimento
