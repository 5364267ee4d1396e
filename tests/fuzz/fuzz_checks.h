#pragma once
// What every target of the fuzzer checks.

#include <string_view>

#include "core/base/check.h"
#include "core/base/result.h"

namespace pentimento::test {

/// The name of the file that a target reads.
inline constexpr const char* kFuzzName = "in.bin";

/// One line that names the file.
inline void check_problem(const Error& error, std::string_view name) {
  PENTIMENTO_CHECK(error.code == ErrorCode::kBadInput || error.code == ErrorCode::kLimit);
  PENTIMENTO_CHECK(error.message.find(name) != std::string::npos);
  PENTIMENTO_CHECK(error.message.size() < 400);
  for (const char c : error.message) PENTIMENTO_CHECK(c >= ' ' || static_cast<signed char>(c) < 0);
}

}  // namespace pentimento::test
