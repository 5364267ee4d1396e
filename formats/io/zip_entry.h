#pragma once
// One file out of a zip archive in memory, by libzip.

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace pentimento {

/// A zip archive in memory; `name` is for messages.
struct ZipBytes {
  std::string name;
  std::string_view bytes;
};

/// The content of the entry `entry`, unpacked. Errors: kBadInput "NAME: what" (no archive, no such
/// entry, damaged), kLimit if it unpacks to more than `most_bytes`, whatever it says of itself.
Result<std::string> read_zip_entry(const ZipBytes& archive, const std::string& entry,
                                   std::uint64_t most_bytes);

}  // namespace pentimento
