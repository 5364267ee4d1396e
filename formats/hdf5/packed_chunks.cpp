#include "formats/hdf5/packed_chunks.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <memory>

namespace pentimento::hdf5 {

namespace {

constexpr std::size_t kPackedValueBytes = 4;

/// Shuffle, then deflate, and nothing else.
bool is_packed_alike(hid_t list) {
  if (H5Pget_nfilters(list) != 2) return false;
  constexpr std::array<H5Z_filter_t, 2> kFilters = {H5Z_FILTER_SHUFFLE, H5Z_FILTER_DEFLATE};
  for (unsigned i = 0; i < kFilters.size(); ++i) {
    unsigned flags = 0, config = 0;
    std::size_t count = 0;
    if (H5Pget_filter2(list, i, &flags, &count, nullptr, 0, nullptr, &config) != kFilters[i])
      return false;
  }
  return true;
}

/// Whether what is not in the file reads as zero bits.
bool is_zero_elsewhere(hid_t list) {
  std::uint32_t fill = 1;
  return H5Pget_fill_value(list, H5T_NATIVE_UINT32, &fill) >= 0 && fill == 0;
}

bool has_type(hid_t dataset, bool is_integer) {
  const Handle type(H5Dget_type(dataset), H5Tclose);
  return H5Tequal(type.id(), is_integer ? H5T_STD_U32LE : H5T_IEEE_F32LE) > 0;
}

/// Size of the chunk at `offset` in the file, 0 if there is none, and whether all filters were
/// used. False if it cannot be found.
bool find_chunk(hid_t dataset, std::span<const hsize_t> offset, hsize_t& bytes, bool& filtered) {
  unsigned left_out = 0;
  haddr_t address = HADDR_UNDEF;
  bytes = 0;
  if (H5Dget_chunk_info_by_coord(dataset, offset.data(), &left_out, &address, &bytes) < 0)
    return false;
  if (address == HADDR_UNDEF) bytes = 0;
  filtered = left_out == 0;
  return true;
}

}  // namespace

std::optional<PackedChunks> PackedChunks::of(hid_t dataset, bool is_integer,
                                             std::span<const hsize_t> chunk) {
  const Handle list(H5Dget_create_plist(dataset), H5Pclose);
  if (!list.ok() || H5Pget_layout(list.id()) != H5D_CHUNKED) return std::nullopt;
  std::vector<hsize_t> found(chunk.size());
  const int rank = static_cast<int>(chunk.size());
  if (H5Pget_chunk(list.id(), rank, found.data()) != rank) return std::nullopt;
  if (!std::equal(chunk.begin(), chunk.end(), found.begin())) return std::nullopt;
  if (!is_packed_alike(list.id()) || !is_zero_elsewhere(list.id()) ||
      !has_type(dataset, is_integer))
    return std::nullopt;
  return PackedChunks(dataset);
}

std::optional<std::vector<std::uint8_t>> PackedChunks::fetch(
    std::span<const hsize_t> offset) const {
  hsize_t bytes = 0;
  bool filtered = false;
  if (!find_chunk(dataset_, offset, bytes, filtered)) return std::nullopt;
  std::vector<std::uint8_t> packed(bytes);
  if (packed.empty()) return packed;
  std::uint32_t left_out = 0;
  if (!filtered ||
      H5Dread_chunk(dataset_, H5P_DEFAULT, offset.data(), &left_out, packed.data()) < 0)
    return std::nullopt;
  return packed;
}

bool unpack_chunk(std::span<const std::uint8_t> packed, std::span<std::uint32_t> values) {
  const std::size_t n = values.size();
  std::vector<std::uint8_t> bytes(n * kPackedValueBytes);
  const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> unpacker(
      libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
  // Without a place for the count, as many bytes as there is room for must come out.
  if (!unpacker ||
      libdeflate_zlib_decompress(unpacker.get(), packed.data(), packed.size(), bytes.data(),
                                 bytes.size(), nullptr) != LIBDEFLATE_SUCCESS)
    return false;
  // The shuffle: first bytes of all values, then the second bytes, ...
  const std::uint8_t* in = bytes.data();
  for (std::size_t i = 0; i < n; ++i)
    values[i] = static_cast<std::uint32_t>(in[i]) | static_cast<std::uint32_t>(in[n + i]) << 8 |
                static_cast<std::uint32_t>(in[2 * n + i]) << 16 |
                static_cast<std::uint32_t>(in[3 * n + i]) << 24;
  return true;
}

}  // namespace pentimento::hdf5
