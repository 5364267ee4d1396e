#pragma once
// Global heaps of HDF5 files: blocks that hold texts of variable length. For this folder only.

#include <cstddef>
#include <span>

namespace pentimento::hdf5 {

/// Whether `bytes`, read from a file with lengths of 8 bytes, are a global heap, or the beginning
/// of one, that libhdf5 cannot walk to its end: an object that takes no room keeps it on one spot
/// for ever, and one that is larger than what is left takes it out of its memory. False for all
/// bytes that are no global heap. Source: HDF5 File Format Specification 3.0, III.E.
bool is_endless_heap(std::span<const std::byte> bytes);

}  // namespace pentimento::hdf5
