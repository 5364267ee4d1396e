#include "formats/hdf5/dump_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <functional>
#include <map>
#include <string_view>

#include "formats/hdf5/chunked.h"
#include "formats/hdf5/objects.h"

namespace pentimento::hdf5 {

namespace {

constexpr std::uint32_t kSignBit = 0x80000000u;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

std::ptrdiff_t diff(std::size_t i) {
  return static_cast<std::ptrdiff_t>(i);
}

/// The values of cells that have `n` each, cell after cell: first all the first ones, then all the
/// second ones, ...
TileValues values_apart(const TileValues& values, std::size_t n) {
  TileValues apart(values.size());
  const std::size_t cells = values.size() / n;
  for (std::size_t i = 0; i < cells; ++i)
    for (std::size_t value = 0; value < n; ++value)
      apart[value * cells + i] = values[i * n + value];
  return apart;
}

bool are_alike(const TileValues& values) {
  return std::adjacent_find(values.begin(), values.end(), std::not_equal_to()) == values.end();
}

/// Calls visit(row, column) for the tiles that a window on the grid touches.
template <typename Visit>
void for_tiles(const CellWindow& window, const Visit& visit) {
  for (int row = window.y / kChunkSide; row * kChunkSide < window.y + window.height; ++row)
    for (int column = window.x / kChunkSide; column * kChunkSide < window.x + window.width;
         ++column)
      visit(row, column);
}

/// HDF5 is called from one thread at a time, whichever file it is about.
std::mutex& library() {
  static std::mutex mutex;
  return mutex;
}

std::size_t index_of(std::string_view name) {
  std::size_t i = 0;
  while (std::string_view(kCanvasDatasets[i].name) != name) ++i;
  return i;
}

std::size_t dataset_of(PlaneKind kind) {
  switch (kind) {
    case PlaneKind::kDepth:
      return index_of("/fluid/depth");
    case PlaneKind::kVelocityX:
      return index_of("/fluid/velocity_x");
    case PlaneKind::kVelocityY:
      return index_of("/fluid/velocity_y");
    case PlaneKind::kBase:
      return index_of("/canvas/base");
    case PlaneKind::kPaper:
      return index_of("/canvas/paper");
    case PlaneKind::kReflectance:
      return index_of("/canvas/reflectance");
    case PlaneKind::kPigment:
      break;
  }
  return index_of("/layers/pigment");
}

}  // namespace

Result<std::shared_ptr<const DumpSource>> DumpSource::open(const DumpFile& from,
                                                           const CanvasShape& shape,
                                                           const CanvasGeometry& geometry,
                                                           std::int64_t step,
                                                           std::size_t cache_bytes) {
  std::shared_ptr<DumpSource> source(new DumpSource(from.path, shape, geometry, step, cache_bytes));
  const Silence silence;
  source->file_ = Handle(H5Freopen(from.file), H5Fclose);
  for (const CanvasDataset& what : kCanvasDatasets) {
    source->datasets_.push_back(open_dataset(source->file_.id(), what.name));
    if (!source->datasets_.back().ok())
      return Error{ErrorCode::kBadInput,
                   fmt::format("{}: {} cannot be read", from.path, what.name)};
    source->packed_.push_back(PackedChunks::of(source->datasets_.back().id(), what.is_integer,
                                               chunk_shape(shape_of(shape, what), kChunkSide)));
  }
  return std::shared_ptr<const DumpSource>(std::move(source));
}

Result<void> DumpSource::status() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (problem_) return *problem_;
  return {};
}

int DumpSource::width_of(const TilePlace& place) const {
  return std::min(kChunkSide, shape_.width - place.column * kChunkSide);
}

int DumpSource::height_of(const TilePlace& place) const {
  return std::min(kChunkSide, shape_.height - place.row * kChunkSide);
}

std::vector<hsize_t> DumpSource::offset_of(const TilePlace& place) const {
  std::vector<hsize_t> offset = {static_cast<hsize_t>(place.row) * kChunkSide,
                                 static_cast<hsize_t>(place.column) * kChunkSide};
  const std::size_t rank = shape_of(shape_, kCanvasDatasets[place.dataset]).size();
  if (rank == 3) offset.push_back(0);
  const auto p = static_cast<hsize_t>(place.plane),
             channels = static_cast<hsize_t>(shape_.channels);
  if (rank == 4) offset.insert(offset.begin(), {p / channels, p % channels});
  return offset;
}

/// Takes the chunk out of the file, and unpacks it while other threads may use libhdf5. False if it
/// is not as the writer packs it.
bool DumpSource::load_packed(const TilePlace& place, TileValues& values) const {
  const std::optional<PackedChunks>& chunks = packed_[place.dataset];
  if (!chunks) return false;
  std::optional<std::vector<std::uint8_t>> packed;
  {
    const std::lock_guard<std::mutex> lock(library());
    const Silence silence;
    packed = chunks->fetch(offset_of(place));
  }
  if (!packed) return false;
  values.assign(1, 0);
  if (packed->empty()) return true;
  const std::size_t n = at(cell_values(shape_, kCanvasDatasets[place.dataset]));
  const std::size_t pitch = at(std::min(kChunkSide, shape_.width)) * n;
  TileValues chunk(pitch * at(std::min(kChunkSide, shape_.height)));
  if (!unpack_chunk(*packed, chunk)) return false;
  // Chunks at the right and the lower edge go on beyond it.
  const std::size_t row = at(width_of(place)) * n, rows = at(height_of(place));
  for (std::size_t y = 1; y < rows && row < pitch; ++y)
    std::copy_n(chunk.begin() + diff(y * pitch), row, chunk.begin() + diff(y * row));
  chunk.resize(row * rows);
  values = std::move(chunk);
  return true;
}

/// Lets libhdf5 unpack what the file has. False if it cannot.
bool DumpSource::load_selected(const TilePlace& place, TileValues& values) const {
  const std::size_t index = place.dataset;
  const CanvasDataset& what = kCanvasDatasets[index];
  const std::vector<hsize_t> start = offset_of(place);
  const auto n = static_cast<hsize_t>(cell_values(shape_, what));
  const auto rows = static_cast<hsize_t>(height_of(place));
  const auto columns = static_cast<hsize_t>(width_of(place));
  values.assign(rows * columns * n, 0);
  std::vector<hsize_t> count = {rows, columns};
  if (start.size() == 3) count.push_back(n);
  if (start.size() == 4) count.insert(count.begin(), {1, 1});
  const std::lock_guard<std::mutex> lock(library());
  const Silence silence;
  const Handle space(H5Dget_space(datasets_[index].id()), H5Sclose);
  // The memory has the same shape as the selection in the file; otherwise HDF5 copies value by
  // value.
  const Handle memory(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr),
                      H5Sclose);
  return H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(),
                             nullptr) >= 0 &&
         H5Dread(datasets_[index].id(), what.is_integer ? H5T_NATIVE_UINT32 : H5T_NATIVE_FLOAT,
                 memory.id(), space.id(), H5P_DEFAULT, values.data()) >= 0;
}

/// Reads a tile. What cannot be read, or has a wrong value, is noted and reads as 0.
KeptTile DumpSource::load(const TilePlace& place) const {
  const CanvasDataset& what = kCanvasDatasets[place.dataset];
  TileValues values;
  const bool read = load_packed(place, values) || load_selected(place, values);
  if (are_alike(values)) values = TileValues(1, values.front());  // gives the others' memory back
  const std::string problem = read ? value_problem(what, values) : "cannot be read";
  if (!problem.empty()) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!problem_)
      problem_ = Error{ErrorCode::kBadInput, fmt::format("{}: {} {}", path_, what.name, problem)};
    values.assign(1, 0);
  }
  const std::size_t n = at(cell_values(shape_, what));
  if (values.size() > 1 && n > 1) values = values_apart(values, n);
  return std::make_shared<const TileValues>(std::move(values));
}

KeptTile DumpSource::tile(const TilePlace& place) const {
  return tiles_.get(place.key(), [&] { return load(place); });
}

bool DumpSource::empty(const CellWindow& window) const {
  bool all = true;
  const auto look_at = [&](const TilePlace& place) {
    const KeptTile values = all ? tile(place) : nullptr;
    all = all && values->size() == 1 && (values->front() & ~kSignBit) == 0;
  };
  for_tiles(window, [&](int row, int column) {
    for (const PlaneKind kind : {PlaneKind::kDepth, PlaneKind::kVelocityX, PlaneKind::kVelocityY})
      look_at({dataset_of(kind), 0, row, column});
    for (int p = 0; p < shape_.layers * shape_.channels; ++p)
      look_at({dataset_of(PlaneKind::kPigment), p, row, column});
  });
  return all;
}

void DumpSource::expect(const CellWindow& window, std::span<const PlaneId> planes,
                        const Threads& threads) const {
  std::map<std::uint64_t, TilePlace> places;
  std::size_t bytes = 0;
  for (const PlaneId& plane : planes)
    for_tiles(window, [&](int row, int column) {
      const std::size_t dataset = dataset_of(plane.kind);
      const TilePlace place{dataset, plane_in(plane), row, column};
      if (places.emplace(place.key(), place).second)
        bytes += at(kChunkSide) * at(kChunkSide) *
                 at(cell_values(shape_, kCanvasDatasets[dataset])) * sizeof(std::uint32_t);
    });
  // More than is kept would be read twice.
  if (bytes > tiles_.most_bytes() / 2) return;
  std::vector<TilePlace> list;
  for (const auto& [key, place] : places) list.push_back(place);
  threads.for_ranges(0, static_cast<int>(list.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) tile(list[at(i)]);
  });
}

int DumpSource::plane_in(const PlaneId& plane) const {
  return plane.kind == PlaneKind::kPigment ? plane.layer * shape_.channels + plane.index : 0;
}

template <typename Value>
void DumpSource::read_cells(std::size_t dataset, int plane, int value, int x, int y,
                            std::span<Value> out) const {
  for (std::size_t done = 0; done < out.size();) {
    const TilePlace place = {dataset, plane, y / kChunkSide, x / kChunkSide};
    const int left = x % kChunkSide;
    const std::size_t run = std::min(at(kChunkSide - left), out.size() - done);
    const KeptTile values = tile(place);
    if (values->size() == 1) {
      std::fill_n(&out[done], run, std::bit_cast<Value>(values->front()));
    } else {
      const std::size_t first =
          at((value * height_of(place) + y % kChunkSide) * width_of(place) + left);
      std::memcpy(&out[done], values->data() + first, run * sizeof(Value));
    }
    x += static_cast<int>(run);
    done += run;
  }
}

void DumpSource::read(PlaneId plane, int x, int y, std::span<float> out) const {
  const int value = plane.kind == PlaneKind::kReflectance ? plane.index : 0;
  read_cells(dataset_of(plane.kind), plane_in(plane), value, x, y, out);
  // Velocities point up in a dump.
  if (plane.kind == PlaneKind::kVelocityY)
    for (float& v : out) v = -v;
}

void DumpSource::read_strokes(int x, int y, std::span<std::uint32_t> out) const {
  read_cells(index_of("/layers/stroke"), 0, 0, x, y, out);
}

}  // namespace pentimento::hdf5
