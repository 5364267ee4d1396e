#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>
#include <vector>

#include "formats/hdf5/layout.h"
#include "formats/hdf5/sleep.h"
#include "formats/hdf5/state_dump.h"
#include "formats/io/sha256.h"

namespace pentimento {

namespace {

/// The hash is of little-endian values.
void to_little_endian(std::span<std::uint32_t> values) {
  if constexpr (std::endian::native == std::endian::big)
    for (std::uint32_t& v : values) v = __builtin_bswap32(v);
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

/// Rows of a dataset, read ahead while others are hashed.
class RowsAhead {
 public:
  RowsAhead(const CanvasSource& canvas, const hdf5::CanvasDataset& dataset,
            std::size_t values_per_row, const std::atomic<bool>* cancelled)
      : canvas_(canvas),
        dataset_(dataset),
        cancelled_(cancelled),
        width_(values_per_row),
        rows_(hdf5::row_count(canvas, dataset)),
        at_once_(std::max<std::int64_t>(
            1, static_cast<std::int64_t>(kValuesAhead / std::max<std::size_t>(1, width_)))) {}

  void add_to(Sha256& hash, const Threads& threads) {
    read(0, ready_);
    for (std::int64_t y = 0; y < rows_ && !stopped(); y += at_once_) {
      threads.for_ranges(0, 2, 1, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
          if (i == 0) {
            hash.update(ready_.data(), ready_.size() * sizeof(std::uint32_t));
          } else {
            read(y + at_once_, next_);
          }
        }
      });
      std::swap(ready_, next_);
    }
  }

 private:
  static constexpr std::size_t kValuesAhead = std::size_t{1} << 20;

  bool stopped() const {
    return cancelled_ != nullptr && cancelled_->load(std::memory_order_relaxed);
  }
  void read(std::int64_t first, std::vector<std::uint32_t>& out) const {
    const std::int64_t rows = std::clamp<std::int64_t>(rows_ - first, 0, at_once_);
    out.resize(static_cast<std::size_t>(rows) * width_);
    for (std::int64_t i = 0; i < rows; ++i)
      hdf5::copy_cells(canvas_, dataset_, first + i, 0,
                       {out.data() + static_cast<std::size_t>(i) * width_, width_});
    to_little_endian(out);
  }

  const CanvasSource& canvas_;
  const hdf5::CanvasDataset& dataset_;
  const std::atomic<bool>* cancelled_;
  std::size_t width_;
  std::int64_t rows_, at_once_;
  std::vector<std::uint32_t> ready_, next_;
};

void add_planes(const CanvasSource& canvas, Sha256& hash, const Threads& threads,
                const std::atomic<bool>* cancelled) {
  hash.update(fmt::format("{} {}\nstep {}\n", kStateFormat, kHashVersion, canvas.step()));
  const hdf5::CanvasShape shape = hdf5::shape_of(canvas);
  for (const hdf5::CanvasDataset& dataset : hdf5::kCanvasDatasets) {
    if (dataset.is_derived) continue;
    hash.update(fmt::format("{} {} {}\n", dataset.name, dataset.is_integer ? "uint32" : "float32",
                            fmt::join(hdf5::shape_of(shape, dataset), " ")));
    RowsAhead(canvas, dataset,
              static_cast<std::size_t>(canvas.geometry().width) *
                  static_cast<std::size_t>(hdf5::cell_values(shape, dataset)),
              cancelled)
        .add_to(hash, threads);
  }
}

}  // namespace

std::string state_sha256(const CanvasState& state, const std::atomic<bool>* cancelled) {
  Sha256 hash;
  add_planes(StateSource(state), hash, Threads(1), cancelled);
  if (!state.sleep.empty()) add_sleep(state, hash);
  return hash.hex();
}

std::string state_sha256(const CanvasSource& canvas, const Threads& threads,
                         const std::atomic<bool>* cancelled) {
  Sha256 hash;
  add_planes(canvas, hash, threads, cancelled);
  return hash.hex();
}

}  // namespace pentimento
