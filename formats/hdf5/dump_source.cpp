#include "formats/hdf5/dump_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <string_view>

#include "formats/hdf5/objects.h"

namespace pentimento::hdf5 {

namespace {

constexpr int kTile = 256;  // cells a side: the writer's chunk
constexpr std::uint32_t kSignBit = 0x80000000u;

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
  }
  return std::shared_ptr<const DumpSource>(std::move(source));
}

Result<void> DumpSource::status() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (problem_) return *problem_;
  return {};
}

/// The tile's cells, row after row; the tile is cut at the right and the lower edge.
bool DumpSource::load(const Key& key, std::vector<std::uint32_t>& values) const {
  const auto [index, plane, row, column] = key;
  const CanvasDataset& what = kCanvasDatasets[index];
  const auto n = static_cast<hsize_t>(cell_values(shape_, what));
  const auto y = static_cast<hsize_t>(row) * kTile, x = static_cast<hsize_t>(column) * kTile;
  const hsize_t rows = std::min<hsize_t>(kTile, static_cast<hsize_t>(shape_.height) - y);
  const hsize_t columns = std::min<hsize_t>(kTile, static_cast<hsize_t>(shape_.width) - x);
  values.assign(rows * columns * n, 0);
  std::vector<hsize_t> start = {y, x}, count = {rows, columns};
  const std::size_t rank = shape_of(shape_, what).size();
  if (rank == 3) {
    start.push_back(0);
    count.push_back(n);
  } else if (rank == 4) {
    const auto p = static_cast<hsize_t>(plane), channels = static_cast<hsize_t>(shape_.channels);
    start.insert(start.begin(), {p / channels, p % channels});
    count.insert(count.begin(), {1, 1});
  }
  const std::lock_guard<std::mutex> lock(library());
  const Silence silence;
  const Handle space(H5Dget_space(datasets_[index].id()), H5Sclose);
  // The memory has the same shape as the selection in the file; otherwise HDF5 copies value by
  // value.
  const Handle memory(H5Screate_simple(static_cast<int>(rank), count.data(), nullptr), H5Sclose);
  return H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(),
                             nullptr) >= 0 &&
         H5Dread(datasets_[index].id(), what.is_integer ? H5T_NATIVE_UINT32 : H5T_NATIVE_FLOAT,
                 memory.id(), space.id(), H5P_DEFAULT, values.data()) >= 0;
}

void DumpSource::make_room() const {
  while (held_bytes_ > cache_bytes_ && !tiles_.empty()) {
    const auto oldest = tiles_.find(ages_.back());
    held_bytes_ -= oldest->second.values.size() * sizeof(std::uint32_t);
    tiles_.erase(oldest);
    ages_.pop_back();
  }
}

const DumpSource::ReadTile& DumpSource::tile(const Key& key) const {
  if (const auto found = tiles_.find(key); found != tiles_.end()) {
    ages_.splice(ages_.begin(), ages_, found->second.age);
    return found->second;
  }
  ReadTile made;
  const CanvasDataset& what = kCanvasDatasets[std::get<0>(key)];
  const bool read = load(key, made.values);
  const std::string problem = read ? value_problem(what, made.values) : "cannot be read";
  if (!problem.empty()) {
    if (!problem_)
      problem_ = Error{ErrorCode::kBadInput, fmt::format("{}: {} {}", path_, what.name, problem)};
    std::fill(made.values.begin(), made.values.end(), 0u);
  }
  ages_.push_front(key);
  made.age = ages_.begin();
  held_bytes_ += made.values.size() * sizeof(std::uint32_t);
  make_room();
  return tiles_.emplace(key, std::move(made)).first->second;
}

void DumpSource::read_run(std::size_t dataset, int plane, int value, int x, int y,
                          std::span<std::uint32_t> out) const {
  const int n = cell_values(shape_, kCanvasDatasets[dataset]);
  const std::lock_guard<std::mutex> lock(mutex_);
  for (std::size_t done = 0; done < out.size();) {
    const int column = x / kTile, left = column * kTile;
    const int width = std::min(kTile, shape_.width - left);
    const int run = std::min(left + width - x, static_cast<int>(out.size() - done));
    const ReadTile& from = tile({dataset, plane, y / kTile, column});
    const std::uint32_t* in = from.values.data() + ((y % kTile) * width + x - left) * n + value;
    for (int i = 0; i < run; ++i, in += n) out[done++] = *in;
    x += run;
  }
}

void DumpSource::read(PlaneId plane, int x, int y, std::span<float> out) const {
  std::vector<std::uint32_t> bits(out.size());
  const bool pigment = plane.kind == PlaneKind::kPigment;
  read_run(dataset_of(plane.kind), pigment ? plane.layer * shape_.channels + plane.index : 0,
           plane.kind == PlaneKind::kReflectance ? plane.index : 0, x, y, bits);
  // Velocities point up in a dump.
  const std::uint32_t flip = plane.kind == PlaneKind::kVelocityY ? kSignBit : 0;
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = std::bit_cast<float>(bits[i] ^ flip);
}

void DumpSource::read_strokes(int x, int y, std::span<std::uint32_t> out) const {
  read_run(index_of("/layers/stroke"), 0, 0, x, y, out);
}

}  // namespace pentimento::hdf5
