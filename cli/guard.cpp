#include "cli/guard.h"

#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <exception>
#include <new>
#include <string_view>

#include "cli/command.h"
#include "cli/crash_report.h"

namespace pentimento::cli {

namespace {
// What a command may need: compiling shaders is the hungriest. Linux gives a main thread as much.
constexpr rlim_t kStackBytes = rlim_t{8} << 20;

/// Says a line without asking for memory, of which there may be none.
int say(std::string_view line, ErrorCode code) {
  static_cast<void>(!::write(STDERR_FILENO, line.data(), line.size()));
  return exit_code(code);
}

struct GuardedCommand {
  const std::function<int()>& command;
  int code = 0;
};

void* run_task(void* pointer) {
  GuardedCommand& task = *static_cast<GuardedCommand*>(pointer);
  task.code = guarded(task.command);
  return nullptr;
}

bool has_large_stack() {
  rlimit stack{};
  if (getrlimit(RLIMIT_STACK, &stack) != 0) return true;
  return stack.rlim_cur == RLIM_INFINITY || stack.rlim_cur >= kStackBytes;
}
}  // namespace

int guarded(const std::function<int()>& command) {
  report_crashes();
  try {
    return command();
  } catch (const std::bad_alloc&) {
    return say("pentimento: there is no more memory; the outputs are as they were\n",
               ErrorCode::kLimit);
  } catch (const std::exception& error) {
    return fail({ErrorCode::kIo, error.what()});
  }
}

int guarded_on_large_stack(const std::function<int()>& command) {
  pthread_attr_t attributes;
  if (has_large_stack() || pthread_attr_init(&attributes) != 0) return guarded(command);
  pthread_attr_setstacksize(&attributes, kStackBytes);
  GuardedCommand task{command};
  pthread_t thread{};
  const int made = pthread_create(&thread, &attributes, run_task, &task);
  pthread_attr_destroy(&attributes);
  if (made != 0) {
    return say("pentimento: the stack is too small (`ulimit -s`), and there is no other\n",
               ErrorCode::kLimit);
  }
  pthread_join(thread, nullptr);
  return task.code;
}

}  // namespace pentimento::cli
