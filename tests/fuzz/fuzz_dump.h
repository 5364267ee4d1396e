#pragma once
// State dumps, read in this process. HDF5 itself does not withstand every damaged file, which is
// why a user's dump is first read in a child: fuzz.py reads what ends the library once more that
// way.

#include <string_view>

namespace pentimento::test {

/// The bytes are the file.
void fuzz_dump(std::string_view bytes);
/// The bytes choose edits of a sound dump, through HDF5's own functions.
void fuzz_dump_edits(std::string_view bytes);
/// The same, but read as a user's file is: in a child first.
void fuzz_dump_by_child(std::string_view bytes);
void fuzz_dump_edits_by_child(std::string_view bytes);

}  // namespace pentimento::test
