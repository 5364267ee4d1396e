#pragma once
// A log that was made of another one names it.

#include <string>

#include "formats/log/tables/events.h"

namespace pentimento::log {

/// Adds the member `key` (x-...) to the header: {"file":..,"sha256":..}. If there is one, the key
/// gets a number: x-edited-2.
void name_origin(Header& header, const std::string& key, const std::string& file,
                 const std::string& sha256);

}  // namespace pentimento::log
