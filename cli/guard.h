#pragma once
// What stands around every command: a stack that is large enough, and an end in one line for what
// no command expects, a machine that has no more memory.

#include <functional>

namespace pentimento::cli {

/// Runs the command and returns its exit code. If something is thrown, all objects of the command
/// are gone by then, and their temporary files with them; one line on standard error says what it
/// was, and the code is that of a limit (memory) or of a failure of the machine.
int guarded(const std::function<int()>& command);

/// The same on a stack of its own where `ulimit -s` leaves the main thread little.
int guarded_on_large_stack(const std::function<int()>& command);

}  // namespace pentimento::cli
