// A library for LD_PRELOAD that makes calls of the C library fail, so that tests see what a full
// disk, a machine without memory or threads, and a kill do to the command. Two variables say what:
//
//   PENTIMENTO_FAULT=CALL:K:MODE   from the K-th call on (from 1)
//     CALL  write (ENOSPC), sync (EIO), rename (EIO), memory (ENOMEM), thread (EAGAIN),
//           publish (all calls that change a file or a folder; for MODE kill)
//     MODE  once, on (this call and all after it), kill (SIGKILL before the call),
//           hold (the call never ends; the number of calls is written when it begins)
//   PENTIMENTO_FAULT_COUNT=FILE    gets the number of such calls when the process ends
//   PENTIMENTO_FAULT_ROUNDING=1    the process starts rounding upwards and without denormals
//
// Only files count, and standard output; what is written to standard error is never disturbed.

#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

#include <atomic>
#include <cerrno>
#include <cfenv>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" {
void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);
}

namespace {

enum class Call { kNone, kWrite, kSync, kRename, kMemory, kThread, kPublish };
enum class Mode { kOnce, kOn, kKill, kHold };

struct Plan {
  Call call = Call::kNone;
  long first = 0;
  Mode mode = Mode::kOnce;
};

Plan plan;
std::atomic<long> calls{0};
std::atomic<bool> ready{false};

Call call_of(const char* name, size_t length) {
  const auto is = [&](const char* other) {
    return std::strlen(other) == length && std::strncmp(name, other, length) == 0;
  };
  if (is("write")) return Call::kWrite;
  if (is("sync")) return Call::kSync;
  if (is("rename")) return Call::kRename;
  if (is("memory")) return Call::kMemory;
  if (is("thread")) return Call::kThread;
  if (is("publish")) return Call::kPublish;
  return Call::kNone;
}

__attribute__((constructor)) void begin() {
  if (std::getenv("PENTIMENTO_FAULT_ROUNDING") != nullptr) {
    std::fesetround(FE_UPWARD);
#if defined(__x86_64__)
    _mm_setcsr(_mm_getcsr() | 0x8040);  // flush to zero, denormals are zero
#endif
  }
  const char* text = std::getenv("PENTIMENTO_FAULT");
  if (text == nullptr) return;
  const char* colon = std::strchr(text, ':');
  if (colon == nullptr) return;
  plan.call = call_of(text, static_cast<size_t>(colon - text));
  plan.first = std::strtol(colon + 1, nullptr, 10);
  const char* mode = std::strrchr(text, ':') + 1;
  plan.mode = std::strcmp(mode, "kill") == 0   ? Mode::kKill
              : std::strcmp(mode, "hold") == 0 ? Mode::kHold
              : std::strcmp(mode, "on") == 0   ? Mode::kOn
                                               : Mode::kOnce;
  ready = true;
}

__attribute__((destructor)) void tell_number_of_calls() {
  const char* path = std::getenv("PENTIMENTO_FAULT_COUNT");
  if (path == nullptr || !ready.exchange(false)) return;
  char text[32];
  const int length = std::snprintf(text, sizeof text, "%ld\n", calls.load());
  const int file = ::open(path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (file < 0) return;
  static_cast<void>(!::write(file, text, static_cast<size_t>(length)));
  ::close(file);
}

/// Counts a call; whether it is to fail.
bool fails(Call call) {
  if (!ready.load(std::memory_order_relaxed)) return false;
  if (plan.mode == Mode::kKill && plan.call == Call::kPublish) {
    if (call == Call::kMemory || call == Call::kThread) return false;
  } else if (call != plan.call) {
    return false;
  }
  const long number = ++calls;
  if (plan.first <= 0 || number < plan.first) return false;
  if (plan.mode == Mode::kKill) ::kill(::getpid(), SIGKILL);
  if (plan.mode == Mode::kHold && number == plan.first) {
    tell_number_of_calls();
    for (;;) ::pause();
  }
  return plan.mode == Mode::kOn || number == plan.first;
}

template <typename Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

bool is_output(int descriptor) {
  return descriptor != STDERR_FILENO;
}

template <typename Value>
Value failed(int error_number, Value value) {
  errno = error_number;
  return value;
}

}  // namespace

extern "C" {

ssize_t write(int file, const void* bytes, size_t count) {
  static auto* const real = next<ssize_t(int, const void*, size_t)>("write");
  return is_output(file) && fails(Call::kWrite) ? failed<ssize_t>(ENOSPC, -1)
                                                : real(file, bytes, count);
}
ssize_t pwrite(int file, const void* bytes, size_t count, off_t offset) {
  static auto* const real = next<ssize_t(int, const void*, size_t, off_t)>("pwrite");
  return fails(Call::kWrite) ? failed<ssize_t>(ENOSPC, -1) : real(file, bytes, count, offset);
}
ssize_t pwrite64(int file, const void* bytes, size_t count, off64_t offset) {
  static auto* const real = next<ssize_t(int, const void*, size_t, off64_t)>("pwrite64");
  return fails(Call::kWrite) ? failed<ssize_t>(ENOSPC, -1) : real(file, bytes, count, offset);
}
int fsync(int file) {
  static auto* const real = next<int(int)>("fsync");
  return fails(Call::kSync) ? failed(EIO, -1) : real(file);
}
int rename(const char* from, const char* to) {
  static auto* const real = next<int(const char*, const char*)>("rename");
  return fails(Call::kRename) ? failed(EIO, -1) : real(from, to);
}
int link(const char* from, const char* to) {
  static auto* const real = next<int(const char*, const char*)>("link");
  return fails(Call::kRename) ? failed(EIO, -1) : real(from, to);
}
int unlink(const char* path) {
  static auto* const real = next<int(const char*)>("unlink");
  return fails(Call::kPublish) ? failed(EIO, -1) : real(path);
}
int close(int file) {
  static auto* const real = next<int(int)>("close");
  return fails(Call::kPublish) ? failed(EIO, -1) : real(file);
}
int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*start)(void*),
                   void* argument) {
  static auto* const real =
      next<int(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*)>("pthread_create");
  return fails(Call::kThread) ? EAGAIN : real(thread, attributes, start, argument);
}

void* malloc(size_t size) {
  return fails(Call::kMemory) ? failed<void*>(ENOMEM, nullptr) : __libc_malloc(size);
}
void* calloc(size_t count, size_t size) {
  return fails(Call::kMemory) ? failed<void*>(ENOMEM, nullptr) : __libc_calloc(count, size);
}
void* realloc(void* old, size_t size) {
  return fails(Call::kMemory) ? failed<void*>(ENOMEM, nullptr) : __libc_realloc(old, size);
}
void* aligned_alloc(size_t alignment, size_t size) {
  return fails(Call::kMemory) ? failed<void*>(ENOMEM, nullptr) : __libc_memalign(alignment, size);
}
int posix_memalign(void** out, size_t alignment, size_t size) {
  if (fails(Call::kMemory)) return ENOMEM;
  *out = __libc_memalign(alignment, size);
  return *out != nullptr ? 0 : ENOMEM;
}

}  // extern "C"
