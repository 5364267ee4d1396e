#include "core/base/side_work.h"

#include <pthread.h>

#include <memory>
#include <utility>

#include "core/base/plain_thread.h"

namespace pentimento {

SideWork::~SideWork() {
  join();
}

void SideWork::begin(std::function<void()> work) {
  wait();
  // Shared, for the thread that cannot be made leaves the work to the caller.
  const auto shared = std::make_shared<std::function<void()>>(std::move(work));
  const auto guarded = [this, shared] {
    try {
      (*shared)();
    } catch (...) {
      problem_ = std::current_exception();
    }
  };
  thread_ = start_plain_thread(guarded);
  if (!thread_) guarded();
}

void SideWork::wait() {
  join();
  if (problem_) std::rethrow_exception(std::exchange(problem_, nullptr));
}

void SideWork::join() {
  if (thread_) pthread_join(*thread_, nullptr);
  thread_.reset();
}

}  // namespace pentimento
