#pragma once
// The first line of a log becomes a Header.

#include <string>

#include "formats/log/json/json_line.h"
#include "formats/log/tables/events.h"

namespace pentimento::log {

/// The version of the format that is written, and the newest that is read.
inline constexpr int kLogVersion = 1;

/// Returns what is wrong, or an empty string.
std::string parse_header(const JsonLine& json, Header& header);

}  // namespace pentimento::log
