#pragma once
// Says in words what is wrong with a line that is not JSON, and where: people write logs by hand.

#include <string>
#include <string_view>

namespace pentimento::log {

/// What is wrong at the first place where `line` is not JSON, as "column 7: NaN is not a number of
/// JSON". Columns count characters from 1. Empty if nothing is wrong. A second parser is asked for
/// the place, since the fast one does not tell it; so this is for messages only.
std::string json_fault(std::string_view line);

}  // namespace pentimento::log
