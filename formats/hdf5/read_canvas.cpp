#include "formats/hdf5/read_canvas.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <functional>

#include "core/model/model.h"
#include "formats/hdf5/handle.h"
#include "formats/hdf5/lighting_parts.h"
#include "formats/hdf5/objects.h"
#include "formats/hdf5/read_small.h"

namespace pentimento::hdf5 {

namespace {

using Shape = std::vector<std::uint64_t>;

// Optical channels are 1 + 2 per band, of which a model has at most 38.
constexpr std::uint64_t kMostBands = 64;
constexpr std::uint64_t kMostChannels = 1 + 2 * kMostBands;
constexpr std::uint64_t kBlockValues = std::uint64_t{1} << 20;  // read at once

Error bad(const std::string& path, const std::string& what) {
  return {ErrorCode::kBadInput, path + ": " + what};
}

Result<void> check_shape(const CanvasGroup& from, const char* name, const Shape& found,
                         const Shape& needed) {
  if (found == needed) return {};
  return bad(from.path, fmt::format("{}{} is {}, must be {}", from.group, name,
                                    fmt::join(found, " x "), fmt::join(needed, " x ")));
}

Result<Shape> shape_in_file(const CanvasGroup& from, const char* name, std::size_t rank) {
  const std::string problem = dataset_problem(from.file, from.group + name);
  if (!problem.empty()) return bad(from.path, problem);
  const std::optional<Shape> shape = dataset_shape(from.file, from.group + name);
  if (!shape) return bad(from.path, fmt::format("{}{} is missing", from.group, name));
  if (shape->size() != rank)
    return bad(from.path, fmt::format("{}{} has {} dimensions, must have {}", from.group, name,
                                      shape->size(), rank));
  return *shape;
}

/// The part of a dataset that `block` rows from `row` on make, in a plane-after-plane count.
/// `count` becomes its shape.
bool select_rows(hid_t space, const Shape& shape, std::uint64_t row, std::uint64_t rows,
                 hsize_t (&count)[4]) {
  hsize_t start[4] = {};
  const std::size_t rank = shape.size();
  for (std::size_t i = 0; i < rank; ++i) count[i] = shape[i];
  const std::size_t y_axis = rank == 3 ? 0 : rank - 2;
  const std::uint64_t ny = shape[y_axis];
  start[y_axis] = row % ny;
  count[y_axis] = rows;
  if (rank == 4) {
    start[0] = row / ny / shape[1];
    start[1] = row / ny % shape[1];
    count[0] = count[1] = 1;
  }
  return H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, count, nullptr) >= 0;
}

/// Calls take(row, values) for each row of the dataset, in order, until it returns false. Errors:
/// kBadInput, kInterrupted.
Result<void> for_each_row(
    const DumpFile& from, const std::string& name, const Shape& shape, hid_t type,
    const std::function<bool(std::int64_t, std::span<const std::uint32_t>)>& take) {
  const std::size_t rank = shape.size();
  const std::uint64_t ny = rank == 3 ? shape[0] : shape[rank - 2];
  const std::uint64_t row_values = rank == 3 ? shape[1] * shape[2] : shape[rank - 1];
  const std::uint64_t planes = rank == 4 ? shape[0] * shape[1] : 1;
  if (planes * ny * row_values == 0) return {};
  const Error unreadable = bad(from.path, name + " cannot be read");
  const Handle dataset = open_dataset(from.file, name);
  if (!dataset.ok()) return unreadable;
  const Handle space(H5Dget_space(dataset.id()), H5Sclose);
  const std::uint64_t block = std::clamp<std::uint64_t>(kBlockValues / row_values, 1, ny);
  std::vector<std::uint32_t> values(block * row_values);
  for (std::uint64_t plane = 0; plane < planes; ++plane) {
    for (std::uint64_t y = 0; y < ny; y += block) {
      if (Result<void> go = from.go_on(); !go) return go;
      const std::uint64_t rows = std::min(block, ny - y);
      hsize_t count[4] = {};
      if (!select_rows(space.id(), shape, plane * ny + y, rows, count)) return unreadable;
      // The memory has the same shape as the selection in the file; otherwise HDF5 copies value by
      // value.
      const Handle memory(H5Screate_simple(static_cast<int>(rank), count, nullptr), H5Sclose);
      if (H5Dread(dataset.id(), type, memory.id(), space.id(), H5P_DEFAULT, values.data()) < 0)
        return unreadable;
      for (std::uint64_t i = 0; i < rows; ++i)
        if (!take(static_cast<std::int64_t>(plane * ny + y + i),
                  std::span(values).subspan(i * row_values, row_values)))
          return {};
    }
  }
  return {};
}

/// Bytes of a plane in memory, whose rows begin at multiples of 64 bytes.
std::uint64_t plane_bytes(std::uint64_t width, std::uint64_t height) {
  return (width * 4 + 63) / 64 * 64 * height;
}

}  // namespace

Result<CanvasShape> canvas_shape(const CanvasGroup& from, const ShapeLimits& limits) {
  const std::string& path = from.path;
  const Result<Shape> plane = shape_in_file(from, "/fluid/depth", 2);
  if (!plane) return plane.error();
  const Result<Shape> bands = shape_in_file(from, "/canvas/reflectance", 3);
  if (!bands) return bands.error();
  const Result<Shape> pigment = shape_in_file(from, "/layers/pigment", 4);
  if (!pigment) return pigment.error();
  const std::uint64_t ny = (*plane)[0], nx = (*plane)[1];
  const std::uint64_t layers = (*pigment)[0], channels = (*pigment)[1];
  if (ny == 0 || nx == 0) return bad(path, fmt::format("the canvas has {} x {} cells", nx, ny));
  const std::uint64_t planes =
      std::min(layers, limits.values) * std::min(channels, kMostChannels + 1) + (*bands)[2];
  if (nx > limits.side || ny > limits.side || nx * ny > limits.cells || channels > kMostChannels ||
      (*bands)[2] > kMostBands || planes > limits.values / (nx * ny))
    return Error{
        ErrorCode::kLimit,
        fmt::format("{}: {} x {} cells in {} planes is more than is read", path, nx, ny, planes)};
  if (layers < 1 || layers > std::uint64_t{kMaxLayers})
    return bad(path, fmt::format("{} layers, must be 1 to {}", layers, kMaxLayers));
  if ((*bands)[2] < 1) return bad(path, from.group + "/canvas/reflectance has no bands");
  if (!may_hold(from.file, nx * ny * planes * 4))
    return bad(path, fmt::format("{} x {} cells in {} planes are more than a file of its size has",
                                 nx, ny, planes));
  const CanvasShape shape = {static_cast<int>(nx), static_cast<int>(ny), static_cast<int>(layers),
                             static_cast<int>(channels), static_cast<int>((*bands)[2])};
  for (const CanvasDataset& dataset : kCanvasDatasets) {
    const Shape needed = shape_of(shape, dataset);
    const Result<Shape> found = shape_in_file(from, dataset.name, needed.size());
    if (!found) return found.error();
    if (const Result<void> fits = check_shape(from, dataset.name, *found, needed); !fits)
      return fits.error();
  }
  return shape;
}

Result<CanvasState> empty_canvas(const CanvasGroup& from) {
  constexpr ShapeLimits kLimits = {65536, std::uint64_t{1} << 28, std::uint64_t{1} << 32};
  const Result<CanvasShape> shape = canvas_shape(from, kLimits);
  if (!shape) return shape.error();
  // Depth, velocities, base, paper and strokes are further planes.
  const std::uint64_t planes =
      static_cast<std::uint64_t>(shape->layers) * static_cast<std::uint64_t>(shape->channels) +
      static_cast<std::uint64_t>(shape->bands) + 6;
  const std::uint64_t held = planes * plane_bytes(static_cast<std::uint64_t>(shape->width),
                                                  static_cast<std::uint64_t>(shape->height));
  from.rehearsal.expect(held, held);
  CanvasGeometry geometry;
  geometry.width = shape->width;
  geometry.height = shape->height;
  return make_canvas_state(geometry, shape->layers, shape->channels, shape->bands, 0);
}

Result<void> read_canvas(const CanvasGroup& from, const CanvasDataset& dataset,
                         CanvasState& state) {
  const std::string name = from.group + dataset.name;
  Result<void> right;
  const Result<void> read = for_each_row(
      from, name, shape_of(shape_of(StateSource(state)), dataset),
      dataset.is_integer ? H5T_NATIVE_UINT32 : H5T_NATIVE_FLOAT,
      [&](std::int64_t row, std::span<const std::uint32_t> values) {
        const std::string problem = value_problem(dataset, values);
        if (!problem.empty())
          right = bad(from.path,
                      fmt::format("{} {} in row {}", name, problem, row % state.geometry.height));
        store_row(state, dataset, row, values);
        return right.ok();
      });
  return read ? right : read;
}

Result<std::array<Field<float>, 3>> read_rgb_planes(const DumpFile& from,
                                                    const LightPicture& picture) {
  const std::string name = picture.name;
  const std::string problem = dataset_problem(from.file, name);
  if (!problem.empty()) return bad(from.path, problem);
  const std::optional<Shape> shape = dataset_shape(from.file, name);
  if (!shape || shape->size() != 3 || (*shape)[2] != 3 || (*shape)[0] > picture.most_rows ||
      (*shape)[1] > picture.most_columns || (*shape)[0] * (*shape)[1] > picture.most_pixels)
    return bad(from.path,
               fmt::format("{} must be rows x columns x 3, at most {} x {} and {} pixels", name,
                           picture.most_rows, picture.most_columns, picture.most_pixels));
  const std::uint64_t held = 3 * plane_bytes((*shape)[1], (*shape)[0]);
  from.rehearsal.expect(held, held);
  std::array<Field<float>, 3> rgb;
  for (Field<float>& plane : rgb)
    plane = Field<float>(static_cast<int>((*shape)[1]), static_cast<int>((*shape)[0]));
  bool right = true;
  const Result<void> read =
      for_each_row(from, name, *shape, H5T_NATIVE_FLOAT,
                   [&](std::int64_t row, std::span<const std::uint32_t> values) {
                     for (std::size_t i = 0; i < values.size(); ++i) {
                       const float value = std::bit_cast<float>(values[i]);
                       right = right && value >= -kMostLight && value <= kMostLight;
                       rgb[i % 3].row(static_cast<int>(row))[i / 3] = value;
                     }
                     return right;
                   });
  if (!read) return read.error();
  if (!right) return bad(from.path, name + " has a value that is not finite or out of range");
  return rgb;
}

}  // namespace pentimento::hdf5
