#pragma once
// The files that a log names: relative to the log's folder, and not outside of it unless allowed.

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace pentimento::log {

/// What is wrong with the name itself, as `file "../a.png" leaves the log's folder`; empty if
/// nothing. Does not look at the disk.
std::string file_name_problem(std::string_view name, bool allow_outside);

/// The existing regular file that `name` means in a log read from `log_path` ("-": the current
/// folder). Links are followed; where they lead must lie in the log's folder, unless allowed.
/// Errors: kBadInput.
Result<std::filesystem::path> resolve_file(const std::string& log_path, std::string_view name,
                                           bool allow_outside);

}  // namespace pentimento::log
