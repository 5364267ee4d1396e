#include "cli/signals.h"

#include <csignal>

namespace pentimento::cli {

namespace {
// A signal handler can only reach a global.
std::atomic<bool> asked_to_stop{false};
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void ask_to_stop(int) {
  asked_to_stop.store(true, std::memory_order_relaxed);
}
}  // namespace

const std::atomic<bool>& watch_signals() {
  struct sigaction action {};
  action.sa_handler = ask_to_stop;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error of writing, not a death
  std::signal(SIGXFSZ, SIG_IGN);  // so is a file that may not grow
  return asked_to_stop;
}

}  // namespace pentimento::cli
