#pragma once
// The result of anything that can fail at the borders of formats, replay and cli, and of core's
// graphics context, which is the one part of core that depends on the machine. A message is one
// line for the user. It names the file, the line or offset, the value and the limit.

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "core/base/check.h"

namespace pentimento {

/// What kind of failure it is; cli maps each to an exit code (docs/cli.md).
enum class ErrorCode {
  kBadInput,    // exit 3: a file or log that is not as it must be
  kUsage,       // exit 2: the command was called wrongly
  kLimit,       // exit 4: refused, over a limit
  kIo,          // exit 5: reading or writing failed
  kNonFinite,   // exit 6: the simulation left the finite numbers
  kInterrupted  // exit 75: stopped by a signal
};

/// What went wrong; `message` as above.
struct Error {
  ErrorCode code = ErrorCode::kBadInput;
  std::string message;
};

template <typename T>
/// A value, or the error why there is none. Asking for the one that is not there aborts.
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}
  Result(Error error) : state_(std::move(error)) {}

  bool ok() const { return std::holds_alternative<T>(state_); }
  explicit operator bool() const { return ok(); }
  T& value() {
    PENTIMENTO_CHECK(ok());
    return std::get<T>(state_);
  }
  const T& value() const {
    PENTIMENTO_CHECK(ok());
    return std::get<T>(state_);
  }
  T& operator*() { return value(); }
  const T& operator*() const { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  const Error& error() const {
    PENTIMENTO_CHECK(!ok());
    return std::get<Error>(state_);
  }

 private:
  std::variant<T, Error> state_;
};

template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}
  bool ok() const { return !error_.has_value(); }
  explicit operator bool() const { return ok(); }
  const Error& error() const {
    PENTIMENTO_CHECK(!ok());
    return *error_;
  }

 private:
  std::optional<Error> error_;
};

}  // namespace pentimento
