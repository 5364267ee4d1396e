#pragma once
// A fault that ends the process (a signal like SIGSEGV or SIGABRT, in our code or in a library)
// leaves no temporary file and says in one line that it came; who aborts has said why. Mesa crashes
// where memory is not given to it, so a crash close to a limit of address space (`ulimit -v`) ends
// with the exit code of a limit. Any other crash ends by its signal, as it would without this.

namespace pentimento::cli {

/// From now on crashes are reported. Signals that somebody listens to already, as sanitizers do,
/// are left to them. A stack that has no more room is reported if the calling thread's is the one.
void report_crashes();

}  // namespace pentimento::cli
