#pragma once
// Threads that do work of ours: with enough stack, the arithmetic that results are defined by, and
// no signals, which are for the thread that waits for something.

#include <functional>
#include <optional>
#include <thread>

namespace pentimento {

/// Starts a thread that calls work() and ends. Nothing if the machine gives none; then `work` is
/// not called. The caller must join the thread (pthread_join). What `work` throws ends the program.
std::optional<std::thread::native_handle_type> start_plain_thread(std::function<void()> work);

}  // namespace pentimento
