#pragma once
// SIGINT and SIGTERM ask the job to stop. The job ends at a safe point and leaves no file half
// written. A second signal changes nothing.

#include <atomic>

namespace pentimento::cli {

/// From now on signals set the flag that is returned.
const std::atomic<bool>& watch_signals();

}  // namespace pentimento::cli
