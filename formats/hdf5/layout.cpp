#include "formats/hdf5/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string_view>

#include "core/base/check.h"

namespace pentimento::hdf5 {

namespace {

enum class DatasetKind { kPlane, kReflectance, kPigment };

DatasetKind kind_of(const CanvasDataset& dataset) {
  const std::string_view name = dataset.name;
  if (name == "/canvas/reflectance") return DatasetKind::kReflectance;
  if (name == "/layers/pigment") return DatasetKind::kPigment;
  return DatasetKind::kPlane;
}

/// The plane that a dataset of one plane of floats stands for.
PlaneId plane_of(const CanvasDataset& dataset) {
  const std::string_view name = dataset.name;
  if (name == "/fluid/depth") return {PlaneKind::kDepth};
  if (name == "/fluid/velocity_x") return {PlaneKind::kVelocityX};
  if (name == "/fluid/velocity_y") return {PlaneKind::kVelocityY};
  if (name == "/canvas/base") return {PlaneKind::kBase};
  PENTIMENTO_CHECK(name == "/canvas/paper");
  return {PlaneKind::kPaper};
}

bool points_down(const CanvasDataset& dataset) {
  return std::string_view(dataset.name) == "/fluid/velocity_y";
}

constexpr std::uint32_t kSign = 0x80000000u;

/// Reads floats into memory that HDF5 takes as 4-byte values.
void read_bits(const CanvasSource& canvas, PlaneId plane, int x, int y,
               std::span<std::uint32_t> out) {
  std::vector<float> work(out.size());
  canvas.read(plane, x, y, work);
  std::memcpy(out.data(), work.data(), out.size() * sizeof(float));
}

void copy_height(const CanvasSource& canvas, int x, int y, std::span<std::uint32_t> out) {
  std::vector<float> base(out.size()), depth(out.size());
  canvas.read({PlaneKind::kBase}, x, y, base);
  canvas.read({PlaneKind::kDepth}, x, y, depth);
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = std::bit_cast<std::uint32_t>(base[i] + depth[i]);
}

void copy_reflectance(const CanvasSource& canvas, int x, int y, std::span<std::uint32_t> out) {
  const auto bands = static_cast<std::size_t>(canvas.bands());
  std::vector<float> band(out.size() / bands);
  for (std::size_t b = 0; b < bands; ++b) {
    canvas.read(reflectance_plane(static_cast<int>(b)), x, y, band);
    for (std::size_t i = 0; i < band.size(); ++i)
      out[i * bands + b] = std::bit_cast<std::uint32_t>(band[i]);
  }
}

/// Calls store(x, values) for the parts of a row that are not all `zero`, a page's worth each: a
/// plane of zeros to which no zeros are written takes no memory there.
template <typename Store>
void for_parts_unlike(std::uint32_t zero, std::span<const std::uint32_t> row, const Store& store) {
  constexpr std::size_t kPartValues = 1024;
  for (std::size_t x = 0; x < row.size(); x += kPartValues) {
    const auto part = row.subspan(x, std::min(kPartValues, row.size() - x));
    if (std::any_of(part.begin(), part.end(), [=](std::uint32_t bits) { return bits != zero; }))
      store(x, part);
  }
}

}  // namespace

CanvasShape shape_of(const CanvasSource& canvas) {
  return {canvas.geometry().width, canvas.geometry().height, canvas.layers(), canvas.channels(),
          canvas.bands()};
}

std::vector<std::uint64_t> shape_of(const CanvasShape& canvas, const CanvasDataset& dataset) {
  const auto ny = static_cast<std::uint64_t>(canvas.height);
  const auto nx = static_cast<std::uint64_t>(canvas.width);
  switch (kind_of(dataset)) {
    case DatasetKind::kReflectance:
      return {ny, nx, static_cast<std::uint64_t>(canvas.bands)};
    case DatasetKind::kPigment:
      return {static_cast<std::uint64_t>(canvas.layers),
              static_cast<std::uint64_t>(canvas.channels), ny, nx};
    default:
      return {ny, nx};
  }
}

int cell_values(const CanvasShape& canvas, const CanvasDataset& dataset) {
  return kind_of(dataset) == DatasetKind::kReflectance ? canvas.bands : 1;
}

std::int64_t row_count(const CanvasSource& canvas, const CanvasDataset& dataset) {
  const std::int64_t ny = canvas.geometry().height;
  return kind_of(dataset) == DatasetKind::kPigment ? ny * canvas.layers() * canvas.channels() : ny;
}

void copy_cells(const CanvasSource& canvas, const CanvasDataset& dataset, std::int64_t row, int x,
                std::span<std::uint32_t> out) {
  const int ny = canvas.geometry().height;
  const int y = static_cast<int>(row % ny);
  const DatasetKind kind = kind_of(dataset);
  if (dataset.is_derived) return copy_height(canvas, x, y, out);
  if (dataset.is_integer) return canvas.read_strokes(x, y, out);
  if (kind == DatasetKind::kReflectance) return copy_reflectance(canvas, x, y, out);
  const int plane = static_cast<int>(row / ny);
  read_bits(canvas,
            kind == DatasetKind::kPigment
                ? pigment_plane(plane / canvas.channels(), plane % canvas.channels())
                : plane_of(dataset),
            x, y, out);
  if (points_down(dataset))
    for (std::uint32_t& v : out) v ^= kSign;
}

std::string value_problem(const CanvasDataset& dataset, std::span<const std::uint32_t> values) {
  if (dataset.is_integer) return {};
  const auto wrong = std::find_if_not(values.begin(), values.end(), [&](std::uint32_t bits) {
    const float value = std::bit_cast<float>(bits);
    return value >= dataset.least && value <= dataset.most;
  });
  if (wrong == values.end()) return {};
  const float value = std::bit_cast<float>(*wrong);
  if (!std::isfinite(value)) return "has a value that is not finite";
  return fmt::format("has the value {}, outside {}..{}", value, dataset.least, dataset.most);
}

void store_row(CanvasState& fresh, const CanvasDataset& dataset, std::int64_t row,
               std::span<const std::uint32_t> in) {
  const int ny = fresh.geometry.height;
  const int y = static_cast<int>(row % ny);
  const DatasetKind kind = kind_of(dataset);
  PENTIMENTO_CHECK(!dataset.is_derived);
  if (dataset.is_integer) {
    return for_parts_unlike(0, in, [&](std::size_t x, std::span<const std::uint32_t> part) {
      std::memcpy(fresh.stroke.row(y) + x, part.data(), part.size_bytes());
    });
  }
  if (kind == DatasetKind::kReflectance) {
    const auto bands = static_cast<std::size_t>(fresh.bands);
    std::vector<float> values(in.size() / bands);
    for (std::size_t band = 0; band < bands; ++band) {
      for (std::size_t x = 0; x < values.size(); ++x)
        values[x] = std::bit_cast<float>(in[x * bands + band]);
      // A dump does not say what the ground was. A corner is rarely painted.
      if (y == 0) fresh.reflectance[band].fill(values[0]);
      fresh.reflectance[band].write(0, y, values);
    }
    return;
  }
  if (dataset.name == std::string_view("/canvas/paper")) {
    std::vector<float> paper_m(in.size());
    std::memcpy(paper_m.data(), in.data(), in.size() * sizeof(float));
    return write_paper(fresh, 0, y, paper_m);
  }
  Field<float>& plane = kind == DatasetKind::kPigment
                            ? fresh.pigment[static_cast<std::size_t>(row / ny)]
                            : pentimento::plane_of(fresh, plane_of(dataset));
  const std::uint32_t flip = points_down(dataset) ? kSign : 0;
  for_parts_unlike(flip, in, [&](std::size_t x, std::span<const std::uint32_t> part) {
    for (const std::uint32_t bits : part) plane.row(y)[x++] = std::bit_cast<float>(bits ^ flip);
  });
}

}  // namespace pentimento::hdf5
