#pragma once
// Parses values of options as people write them: `1,2,3`, `8G`, `model.nu_max=1e-2`. The locale
// does not matter. Errors: kUsage with the name of the option.

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"

namespace pentimento::cli {

/// Parses exactly `count` finite numbers, separated by commas.
Result<std::vector<double>> parse_numbers(const std::string& option, const std::string& text,
                                          std::size_t count);
Result<double> parse_number(const std::string& option, const std::string& text);
Result<std::array<double, 3>> parse_vector(const std::string& option, const std::string& text);

/// Bytes: a number, and K, M, G or T for powers of 1024.
Result<std::int64_t> parse_bytes(const std::string& option, const std::string& text);

/// Seconds: a number, and s, m or h.
Result<double> parse_duration(const std::string& option, const std::string& text);

/// `I/N`, one of N shares, from 1 on.
Result<std::pair<int, int>> parse_share(const std::string& option, const std::string& text);

/// `model.NAME=VALUE` as NAME and VALUE.
Result<std::pair<std::string, std::string>> parse_model_setting(const std::string& text);

}  // namespace pentimento::cli
