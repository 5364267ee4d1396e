#pragma once
// Name and version of this program.

#include <string>

namespace pentimento {

/// "0.1.0".
std::string version();
/// "pentimento 0.1.0 (1a2b3c4, GNU 12.2.0, Release)".
std::string software();

}  // namespace pentimento
