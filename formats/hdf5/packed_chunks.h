#pragma once
// Reads chunks of a dataset as they lie in the file and unpacks them outside of libhdf5, which
// works for one thread at a time. For this folder only.

#include <hdf5.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "formats/hdf5/handle.h"

namespace pentimento::hdf5 {

/// Chunks that were packed as write_chunked() packs them. The dataset must stay open.
class PackedChunks {
 public:
  /// nullopt unless the dataset has little-endian values of 4 bytes, whole numbers or floats as
  /// `is_integer` says, in chunks of the shape `chunk`, shuffled, then deflated, and 0 where the
  /// file has no chunk. H5Dread reads the others.
  static std::optional<PackedChunks> of(hid_t dataset, bool is_integer,
                                        std::span<const hsize_t> chunk);

  /// The packed chunk that begins at `offset`; empty where the file has none, and all values are 0.
  /// nullopt: cannot be read, or was left unpacked. Calls libhdf5.
  std::optional<std::vector<std::uint8_t>> fetch(std::span<const hsize_t> offset) const;

 private:
  explicit PackedChunks(hid_t dataset) : dataset_(dataset) {}
  hid_t dataset_;
};

/// The values of a packed chunk. False if it is damaged, or has another number of values. Does not
/// call libhdf5.
bool unpack_chunk(std::span<const std::uint8_t> packed, std::span<std::uint32_t> values);

}  // namespace pentimento::hdf5
