#pragma once
// Slow scans of a line of JSON, for messages and rare cases.

#include <string>
#include <string_view>

namespace pentimento::log {

/// Whether `line` ends inside an object, array or string, as a line does that was cut short.
bool ends_inside_json(std::string_view line);

/// The first number of `line` that a double or a 64-bit integer cannot hold, as
/// "x 1e400 does not fit a double-precision number"; empty if there is none.
std::string unfit_number(std::string_view line);

}  // namespace pentimento::log
