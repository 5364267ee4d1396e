#include "cli/crash_report.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <string_view>

#include "cli/command.h"
#include "formats/io/temporaries.h"

namespace pentimento::cli {

namespace {
constexpr int kFaults[] = {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT};

/// A library of Mesa's takes 120 MiB at once, and the heap of a thread 64: requests of such sizes
/// are refused this far below the limit.
constexpr std::uint64_t kCloseToLimit_bytes = std::uint64_t{256} << 20;

// A signal handler can only reach a global.
alignas(16) char handler_stack[32 << 10];

/// The pages that the process has mapped: the first number of /proc/self/statm. 0 if it is not
/// known.
std::uint64_t mapped_pages() {
  const int file = open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
  if (file < 0) return 0;
  char digits[32];
  const ssize_t count = read(file, digits, sizeof digits);
  close(file);
  std::uint64_t pages = 0;
  for (ssize_t i = 0; i < count && digits[i] >= '0' && digits[i] <= '9'; ++i)
    pages = pages * 10 + static_cast<std::uint64_t>(digits[i] - '0');
  return pages;
}

bool is_close_to_memory_limit() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return false;
  const std::uint64_t mapped_bytes =
      mapped_pages() * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  return mapped_bytes + kCloseToLimit_bytes >= limit.rlim_cur;
}

void say(std::string_view line) {
  static_cast<void>(!::write(STDERR_FILENO, line.data(), line.size()));
}

extern "C" void report_crash(int signal) {
  remove_temporaries();
  if (is_close_to_memory_limit()) {
    say("pentimento: crashed close to the limit of its memory (`ulimit -v`); no output is half "
        "written\n");
    _exit(exit_code(ErrorCode::kLimit));
  }
  // Who aborts has said why.
  if (signal != SIGABRT) say("pentimento: internal error: crashed; no output is half written\n");
  raise(signal);  // it waits for the end of this handler, and then has its usual effect
}
}  // namespace

void report_crashes() {
  stack_t stack{};
  stack.ss_sp = handler_stack;
  stack.ss_size = sizeof handler_stack;
  sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_handler = report_crash;
  action.sa_flags = SA_ONSTACK | static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  for (const int signal : kFaults) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler == SIG_DFL) sigaction(signal, &action, nullptr);
  }
}

}  // namespace pentimento::cli
