#include "formats/hdf5/layout.h"

#include <bit>
#include <cstring>
#include <string_view>

#include "core/check.h"

namespace pentimento::hdf5 {

namespace {

enum class Kind { kPlane, kReflectance, kPigment };

Kind kind_of(const CanvasDataset& dataset) {
  const std::string_view name = dataset.name;
  if (name == "/canvas/reflectance") return Kind::kReflectance;
  if (name == "/layers/pigment") return Kind::kPigment;
  return Kind::kPlane;
}

/// The plane of float values that a dataset stands for; nullptr for the strokes.
template <typename State>
auto* float_plane(State& state, const CanvasDataset& dataset) {
  const std::string_view name = dataset.name;
  if (name == "/fluid/depth") return &state.depth_m;
  if (name == "/fluid/velocity_x") return &state.velocity_x_m_s;
  if (name == "/fluid/velocity_y") return &state.velocity_y_m_s;
  if (name == "/canvas/base") return &state.base_m;
  PENTIMENTO_CHECK(name == "/canvas/paper");
  return &state.paper_m;
}

bool points_down(const CanvasDataset& dataset) {
  return std::string_view(dataset.name) == "/fluid/velocity_y";
}

std::size_t bytes_of(std::size_t values) {
  return values * sizeof(std::uint32_t);
}

void copy_height(const CanvasState& state, int y, std::span<std::uint32_t> out) {
  for (std::size_t x = 0; x < out.size(); ++x)
    out[x] = std::bit_cast<std::uint32_t>(state.base_m.row(y)[x] + state.depth_m.row(y)[x]);
}

constexpr std::uint32_t kSign = 0x80000000u;

}  // namespace

std::vector<std::uint64_t> shape_of(const CanvasState& state, const CanvasDataset& dataset) {
  const auto ny = static_cast<std::uint64_t>(state.geometry.height);
  const auto nx = static_cast<std::uint64_t>(state.geometry.width);
  switch (kind_of(dataset)) {
    case Kind::kReflectance:
      return {ny, nx, static_cast<std::uint64_t>(state.bands)};
    case Kind::kPigment:
      return {static_cast<std::uint64_t>(state.layers), static_cast<std::uint64_t>(state.channels),
              ny, nx};
    default:
      return {ny, nx};
  }
}

int row_values(const CanvasState& state, const CanvasDataset& dataset) {
  const int nx = state.geometry.width;
  return kind_of(dataset) == Kind::kReflectance ? nx * state.bands : nx;
}

std::int64_t row_count(const CanvasState& state, const CanvasDataset& dataset) {
  const std::int64_t ny = state.geometry.height;
  return kind_of(dataset) == Kind::kPigment ? ny * state.layers * state.channels : ny;
}

void copy_row(const CanvasState& state, const CanvasDataset& dataset, std::int64_t row,
              std::span<std::uint32_t> out) {
  const int ny = state.geometry.height;
  const int y = static_cast<int>(row % ny);
  const Kind kind = kind_of(dataset);
  if (dataset.is_derived) return copy_height(state, y, out);
  if (dataset.is_integer) {
    std::memcpy(out.data(), state.stroke.row(y), bytes_of(out.size()));
    return;
  }
  if (kind == Kind::kReflectance) {
    const auto bands = static_cast<std::size_t>(state.bands);
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = std::bit_cast<std::uint32_t>(state.reflectance[i % bands].row(y)[i / bands]);
    return;
  }
  const Field<float>& plane = kind == Kind::kPigment
                                  ? state.pigment[static_cast<std::size_t>(row / ny)]
                                  : *float_plane(state, dataset);
  std::memcpy(out.data(), plane.row(y), bytes_of(out.size()));
  if (points_down(dataset))
    for (std::uint32_t& v : out) v ^= kSign;
}

void store_row(CanvasState& state, const CanvasDataset& dataset, std::int64_t row,
               std::span<const std::uint32_t> in) {
  const int ny = state.geometry.height;
  const int y = static_cast<int>(row % ny);
  const Kind kind = kind_of(dataset);
  PENTIMENTO_CHECK(!dataset.is_derived);
  if (dataset.is_integer) {
    std::memcpy(state.stroke.row(y), in.data(), bytes_of(in.size()));
    return;
  }
  if (kind == Kind::kReflectance) {
    const auto bands = static_cast<std::size_t>(state.bands);
    for (std::size_t i = 0; i < in.size(); ++i)
      state.reflectance[i % bands].row(y)[i / bands] = std::bit_cast<float>(in[i]);
    return;
  }
  Field<float>& plane = kind == Kind::kPigment ? state.pigment[static_cast<std::size_t>(row / ny)]
                                               : *float_plane(state, dataset);
  const std::uint32_t flip = points_down(dataset) ? kSign : 0;
  for (std::size_t x = 0; x < in.size(); ++x) plane.row(y)[x] = std::bit_cast<float>(in[x] ^ flip);
}

}  // namespace pentimento::hdf5
