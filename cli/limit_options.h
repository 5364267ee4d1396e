#pragma once
// The options that raise the limits of logs (formats/log/tables/limits.h).

#include <string>
#include <vector>

#include "core/base/result.h"
#include "formats/log/tables/limits.h"

namespace CLI {
class App;
}

namespace pentimento::cli {

class LimitOptions {
 public:
  /// `limits` and this object must outlive `app`.
  void add_to(CLI::App& app, log::Limits& limits);
  /// After the options are parsed: what `--limit` says goes into the limits. Errors: kUsage.
  Result<void> complete(log::Limits& limits) const;

 private:
  std::vector<std::string> settings_;
};

}  // namespace pentimento::cli
