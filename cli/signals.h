#pragma once
// SIGINT and SIGTERM ask the job to stop; it ends itself at a safe point and leaves nothing half
// written. Asking again changes nothing.

#include <atomic>

namespace pentimento::cli {

/// From now on signals set the flag that is returned.
const std::atomic<bool>& watch_signals();

}  // namespace pentimento::cli
