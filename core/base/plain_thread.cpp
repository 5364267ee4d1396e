#include "core/base/plain_thread.h"

#include <pthread.h>

#include <csignal>
#include <memory>
#include <utility>

#include "core/base/float_environment.h"

namespace pentimento {

namespace {
// The stack does not follow `ulimit -s`, which may be too small for any work.
constexpr std::size_t kStackBytes = std::size_t{4} << 20;

void* run(void* given) {
  const std::unique_ptr<std::function<void()>> work(static_cast<std::function<void()>*>(given));
  set_plain_arithmetic();
  (*work)();
  return nullptr;
}
}  // namespace

std::optional<std::thread::native_handle_type> start_plain_thread(std::function<void()> work) {
  auto given = std::make_unique<std::function<void()>>(std::move(work));
  pthread_attr_t attributes;
  if (pthread_attr_init(&attributes) != 0) return std::nullopt;
  pthread_attr_setstacksize(&attributes, kStackBytes);
  // The thread has the mask of the one that makes it.
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  pthread_t thread{};
  const bool made = pthread_create(&thread, &attributes, run, given.get()) == 0;
  if (made) static_cast<void>(given.release());
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  pthread_attr_destroy(&attributes);
  return made ? std::optional(thread) : std::nullopt;
}

}  // namespace pentimento
