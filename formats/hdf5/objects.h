#pragma once
// Opens the groups and datasets of a file that may hold anything. What would lead out of the file,
// or cost more than the file's size allows, is refused before it is followed. For the .cpp files of
// this folder only.

#include <hdf5.h>

#include <cstdint>
#include <string>

#include "formats/hdf5/handle.h"

namespace pentimento::hdf5 {

/// In a process that only reads a dump: no file that is read may have a library loaded for it.
void load_no_filters();

/// Whether the file itself holds something under this name. Links to elsewhere hold nothing.
bool holds(hid_t file, const std::string& name);

/// Whether there is nothing of this name, not even a link to elsewhere.
bool lacks(hid_t file, const std::string& name);

/// Why the dataset must not be read: a link on the way to it, values that lie in other files, a
/// filter or a type that no dump has, more values than the file has bytes for. As "/a/b is a soft
/// link"; empty if it may be read, or if there is nothing of that name.
std::string dataset_problem(hid_t file, const std::string& name);

/// Not ok() if there is none, or if it must not be read.
Handle open_dataset(hid_t file, const std::string& name);
/// Not ok() if there is no such group in the file itself.
Handle open_group(hid_t file, const std::string& name);

/// Whether `bytes` of values can be what this file holds. What is zero is not stored, so a file of
/// an empty canvas holds many more values than it has bytes.
bool may_hold(hid_t file, std::uint64_t bytes);

/// Whether a value of this type is a number of 1 to 8 bytes as processors have them, whatever the
/// order of its bytes. The library converts these safely.
bool is_plain_number(hid_t type);

}  // namespace pentimento::hdf5
