#include "cli/signals.h"

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <string_view>

#include "cli/command.h"
#include "formats/io/temporaries.h"

namespace pentimento::cli {

namespace {
constexpr std::int64_t kSameWish_ms = 500;

// A signal handler can only reach a global.
std::atomic<bool> asked_to_stop{false};
std::atomic<std::int64_t> first_asked_ms{0};
static_assert(std::atomic<bool>::is_always_lock_free);
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

std::int64_t now_ms() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1000 + now.tv_nsec / 1'000'000;
}

[[noreturn]] void end_at_once() {
  constexpr std::string_view kLine = "pentimento: interrupted again; ended at once\n";
  remove_temporaries();
  static_cast<void>(!::write(STDERR_FILENO, kLine.data(), kLine.size()));
  _exit(exit_code(ErrorCode::kInterrupted));
}

extern "C" void ask_to_stop(int) {
  const int error_number = errno;
  if (!asked_to_stop.exchange(true)) {
    first_asked_ms.store(now_ms());
  } else if (now_ms() - first_asked_ms.load() > kSameWish_ms) {
    end_at_once();
  }
  errno = error_number;
}
}  // namespace

const std::atomic<bool>& watch_signals() {
  struct sigaction action {};
  action.sa_handler = ask_to_stop;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  struct sigaction before {};
  sigaction(SIGHUP, nullptr, &before);
  // `nohup` has it ignored.
  if (before.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error of writing, not a death
  std::signal(SIGXFSZ, SIG_IGN);  // so is a file that may not grow
  return asked_to_stop;
}

}  // namespace pentimento::cli
