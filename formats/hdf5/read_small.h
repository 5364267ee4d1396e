#pragma once
// Reads attributes and small datasets of a file that may hold anything, so everything is checked. A
// function returns nullopt if there is no such thing. For the .cpp files of this folder only.

#include <hdf5.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "formats/hdf5/handle.h"
#include "formats/io/picture_file.h"

namespace pentimento::hdf5 {

/// Whether there is such an attribute, be it readable or not: it is no missing one then.
bool has_attribute(hid_t object, const std::string& name);
/// Text that is no UTF-8 is mended.
std::optional<std::string> text_attribute(hid_t object, const std::string& name);
std::optional<double> number_attribute(hid_t object, const std::string& name);
std::optional<std::int64_t> whole_attribute(hid_t object, const std::string& name);

/// Why a file with this root is no state dump that can be read; empty if it says that it is one.
std::string format_problem(hid_t root);

/// All attributes of `object` that are text, by name.
Provenance text_attributes(hid_t object);

/// The dataset's shape; nothing if there is no such dataset, or one that must not be read.
std::optional<std::vector<std::uint64_t>> dataset_shape(hid_t file, const std::string& name);

/// The values of a dataset of exactly this shape; nullopt if there is none.
std::optional<std::vector<double>> read_doubles(hid_t file, const std::string& name,
                                                const std::vector<std::uint64_t>& shape);
/// The same for whole numbers.
std::optional<std::vector<std::uint32_t>> read_words(hid_t file, const std::string& name,
                                                     const std::vector<std::uint64_t>& shape);
/// A list of at most `most` strings, of 16 MiB together; nullopt if there is none. Text that is no
/// UTF-8 is mended.
std::optional<std::vector<std::string>> read_strings(hid_t file, const std::string& name,
                                                     std::size_t most);

}  // namespace pentimento::hdf5
