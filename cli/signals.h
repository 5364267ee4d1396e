#pragma once
// SIGINT, SIGTERM and SIGHUP ask the job to stop. The job ends at a safe point and leaves no file
// half written. Who asks again, half a second later or more, does not want to wait: the process
// removes its temporary files and ends at once. (Within half a second the same wish may arrive
// twice: `timeout` and shells send it to the process and to its group.)

#include <atomic>

namespace pentimento::cli {

/// From now on signals set the flag that is returned.
const std::atomic<bool>& watch_signals();

}  // namespace pentimento::cli
