#pragma once
// The options that say where and how often a replay is saved.

#include <string>

#include "core/base/result.h"
#include "replay/job/render_job.h"

namespace CLI {
class App;
}

namespace pentimento::cli {

struct CheckpointOptions {
  std::string folder, every;

  void add_to(CLI::App& app);
  /// Errors: kUsage.
  Result<CheckpointChoice> choice() const;
};

}  // namespace pentimento::cli
