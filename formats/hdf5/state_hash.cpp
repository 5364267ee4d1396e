#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "core/base/interruption.h"
#include "formats/hdf5/layout.h"
#include "formats/hdf5/sleep.h"
#include "formats/hdf5/state_dump.h"
#include "formats/io/sha256.h"

namespace pentimento {

namespace {

using hdf5::CanvasDataset;
using hdf5::CanvasShape;
using hdf5::kChunkSide;

// The version in the first line of what is hashed.
constexpr int kWholeVersion = 1;    // a dataset's values follow its line
constexpr int kInPartsVersion = 2;  // the hashes of its parts follow

/// The hash is of little-endian values.
void to_little_endian(std::span<std::uint32_t> values) {
  if constexpr (std::endian::native == std::endian::big)
    for (std::uint32_t& v : values) v = __builtin_bswap32(v);
}

std::string first_lines(int version, std::int64_t step) {
  return fmt::format("{} {}\nstep {}\n", kStateFormat, version, step);
}

std::string line_of(const CanvasShape& canvas, const CanvasDataset& dataset) {
  return fmt::format("{} {} {}\n", dataset.name, dataset.is_integer ? "uint32" : "float32",
                     fmt::join(hdf5::shape_of(canvas, dataset), " "));
}

void add_sleep(const CanvasState& state, Sha256& hash) {
  const std::vector<float> sleep = hdf5::sleep_to_dump(state);
  hash.update(fmt::format("{} float32 {}\n", hdf5::kSleepName,
                          fmt::join(hdf5::sleep_shape(sleep.size()), " ")));
  std::vector<std::uint32_t> bits(sleep.size());
  std::memcpy(bits.data(), sleep.data(), sleep.size() * sizeof(float));
  to_little_endian(bits);
  hash.update(bits.data(), bits.size() * sizeof(std::uint32_t));
}

void add_rows(const CanvasSource& canvas, const CanvasDataset& dataset,
              const std::atomic<bool>* cancelled, Sha256& hash) {
  const int values = hdf5::cell_values(hdf5::shape_of(canvas), dataset);
  std::vector<std::uint32_t> row(static_cast<std::size_t>(canvas.geometry().width) *
                                 static_cast<std::size_t>(values));
  for (std::int64_t y = 0; y < hdf5::row_count(canvas, dataset) && unless_interrupted(cancelled);
       ++y) {
    hdf5::copy_cells(canvas, dataset, y, 0, row);
    to_little_endian(row);
    hash.update(row.data(), row.size() * sizeof(std::uint32_t));
  }
}

Sha256 whole_planes(const CanvasSource& canvas, const std::atomic<bool>* cancelled) {
  Sha256 hash;
  hash.update(first_lines(kWholeVersion, canvas.step()));
  for (const CanvasDataset& dataset : hdf5::kCanvasDatasets) {
    if (dataset.is_derived) continue;
    hash.update(line_of(hdf5::shape_of(canvas), dataset));
    add_rows(canvas, dataset, cancelled, hash);
  }
  return hash;
}

bool are_alike(std::span<const std::uint32_t> values) {
  return std::memcmp(values.data(), values.data() + 1, values.size_bytes() - sizeof(values[0])) ==
         0;
}

/// Hashes of parts whose values are all alike, each computed once.
class AlikeParts {
 public:
  Sha256Bytes hash(std::uint32_t value, std::size_t count) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto known = known_.find({value, count});
    if (known != known_.end()) return known->second;
    const std::vector<std::uint32_t> values(count, value);
    return known_[{value, count}] = sha256(values.data(), count * sizeof(value));
  }

 private:
  std::mutex mutex_;  // of what follows
  std::map<std::pair<std::uint32_t, std::size_t>, Sha256Bytes> known_;
};

/// Of a dataset in parts of kChunkSide x kChunkSide cells of one plane, which are cut at the right
/// and the lower edge of the canvas. They count plane by plane, then from the top down, then from
/// the left.
class HashedParts {
 public:
  HashedParts(const CanvasSource& canvas, const CanvasDataset& dataset, AlikeParts& alike)
      : canvas_(canvas),
        dataset_(dataset),
        alike_(alike),
        cell_values_(hdf5::cell_values(hdf5::shape_of(canvas), dataset)),
        columns_((canvas.geometry().width + kChunkSide - 1) / kChunkSide),
        rows_((canvas.geometry().height + kChunkSide - 1) / kChunkSide) {}

  int count() const {
    const std::int64_t planes =
        hdf5::row_count(canvas_, dataset_) / std::max(1, canvas_.geometry().height);
    return static_cast<int>(planes) * rows_ * columns_;
  }

  /// `work` is memory that calls of one thread share.
  Sha256Bytes hash(int part, std::vector<std::uint32_t>& work) const {
    const CanvasGeometry& grid = canvas_.geometry();
    const int x = part % columns_ * kChunkSide, y = part / columns_ % rows_ * kChunkSide;
    const CellWindow window = {x, y, std::min(kChunkSide, grid.width - x),
                               std::min(kChunkSide, grid.height - y)};
    const std::int64_t row = std::int64_t{part / columns_ / rows_} * grid.height + y;
    const std::size_t count = size(window.width) * size(window.height) * size(cell_values_);
    if (dataset_.is_paint && canvas_.empty(window)) return alike_.hash(0, count);
    read(window, row, work);
    return are_alike(work) ? alike_.hash(work.front(), count)
                           : sha256(work.data(), count * sizeof(work[0]));
  }

 private:
  static std::size_t size(int n) { return static_cast<std::size_t>(n); }
  /// `row` is where the window begins in the dataset.
  void read(const CellWindow& window, std::int64_t row, std::vector<std::uint32_t>& out) const {
    const std::size_t width = size(window.width) * size(cell_values_);
    out.resize(width * size(window.height));
    for (int y = 0; y < window.height; ++y)
      hdf5::copy_cells(canvas_, dataset_, row + y, window.x,
                       std::span(out).subspan(size(y) * width, width));
    to_little_endian(out);
  }

  const CanvasSource& canvas_;
  const CanvasDataset& dataset_;
  AlikeParts& alike_;
  int cell_values_;
  int columns_, rows_;  // of parts
};

}  // namespace

std::string state_sha256(const CanvasState& state, const std::atomic<bool>* cancelled) {
  Sha256 hash = whole_planes(StateSource(state), cancelled);
  if (!state.sleep.empty()) add_sleep(state, hash);
  return hash.hex();
}

std::string serial_sha256(const CanvasSource& canvas, const std::atomic<bool>* cancelled) {
  return whole_planes(canvas, cancelled).hex();
}

std::string detail_sha256(const CanvasSource& canvas, const Threads& threads,
                          const std::atomic<bool>* cancelled) {
  Sha256 hash;
  hash.update(first_lines(kInPartsVersion, canvas.step()));
  AlikeParts alike;
  for (const CanvasDataset& dataset : hdf5::kCanvasDatasets) {
    if (dataset.is_derived) continue;
    hash.update(line_of(hdf5::shape_of(canvas), dataset));
    const HashedParts parts(canvas, dataset, alike);
    std::vector<Sha256Bytes> hashes(static_cast<std::size_t>(parts.count()));
    threads.for_ranges(0, parts.count(), 1, [&](int begin, int end) {
      std::vector<std::uint32_t> work;
      for (int i = begin; i < end && unless_interrupted(cancelled); ++i)
        hashes[static_cast<std::size_t>(i)] = parts.hash(i, work);
    });
    for (const Sha256Bytes& part : hashes) hash.update(part.data(), part.size());
  }
  return hash.hex();
}

}  // namespace pentimento
