#include "replay/process/child.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

namespace pentimento {

namespace {
constexpr double kGraceSeconds = 5;  // from being asked to end to being killed
constexpr int kNotStarted = 127;     // as a shell says it

/// The new process until it becomes the program. It may only make calls that are safe after a fork
/// beside other threads.
[[noreturn]] void become(const ChildSpec& spec, char* const* words, int parent) {
  setpgid(0, 0);  // a signal of the terminal goes to the batch alone, which tells its children
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int nothing = open("/dev/null", O_RDONLY);
  const int out = open(spec.output_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  const int err = open(spec.message_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  const bool ready = getppid() == parent && nothing >= 0 && out >= 0 && err >= 0 &&
                     dup2(nothing, 0) == 0 && dup2(out, 1) == 1 && dup2(err, 2) == 2 &&
                     chdir(spec.folder.c_str()) == 0;
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  if (ready) execv(spec.program.c_str(), words);
  _exit(kNotStarted);
}
/// Waits until nobody holds the pipe's other end any more.
void await_end(int pipe) {
  char byte = 0;
  while (read(pipe, &byte, 1) < 0 && errno == EINTR) {
  }
}
}  // namespace

std::string_view name_of(ChildEnd end) {
  switch (end) {
    case ChildEnd::kExit:
      return "exit";
    case ChildEnd::kSignal:
      return "signal";
    case ChildEnd::kTimeout:
      return "timeout";
    case ChildEnd::kMemory:
      return "memory";
    case ChildEnd::kStopped:
      return "stopped";
  }
  return "";
}

Result<std::unique_ptr<Child>> Child::start(const ChildSpec& spec) {
  std::vector<std::string> copies{spec.program};
  copies.insert(copies.end(), spec.words.begin(), spec.words.end());
  std::vector<char*> words;
  for (std::string& word : copies) words.push_back(word.data());
  words.push_back(nullptr);
  std::unique_ptr<Child> child(new Child);
  child->timeout_s_ = spec.timeout_s;
  child->memory_bytes_ = spec.memory_bytes;
  child->began_ = Clock::now();
  const auto failed = [] {
    return Error{ErrorCode::kIo, std::string("no process could be started: ") + strerror(errno)};
  };
  // Until the child becomes the program it is a copy of this process, whose memory must not be
  // taken for its own: only the program closes the copy's end of this pipe.
  int ends[2] = {-1, -1};
  if (pipe2(ends, O_CLOEXEC) != 0) return failed();
  const int parent = getpid();
  child->pid_ = fork();
  if (child->pid_ == 0) become(spec, words.data(), parent);
  const Error no_process = failed();
  close(ends[1]);
  if (child->pid_ > 0) await_end(ends[0]);
  close(ends[0]);
  if (child->pid_ < 0) return no_process;
  return child;
}

Child::~Child() {
  if (pid_ < 0) return;
  kill(-pid_, SIGKILL);
  kill(pid_, SIGKILL);
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
}

double Child::seconds() const {
  return std::chrono::duration<double>(Clock::now() - began_).count();
}

std::int64_t Child::memory_now() const {
  char name[64];
  std::snprintf(name, sizeof name, "/proc/%d/statm", pid_);
  std::FILE* file = std::fopen(name, "re");
  if (file == nullptr) return 0;
  long long pages = 0, resident = 0;
  const int read = std::fscanf(file, "%lld %lld", &pages, &resident);
  std::fclose(file);
  return read == 2 ? resident * sysconf(_SC_PAGESIZE) : 0;
}

void Child::end_for(ChildEnd reason) {
  if (ending_) return;
  ending_ = true;
  reason_ = reason;
  told_ = Clock::now();
  // What takes too much memory would take more while it ends.
  kill(pid_, reason == ChildEnd::kMemory ? SIGKILL : SIGTERM);
}

void Child::stop() {
  if (pid_ >= 0) end_for(ChildEnd::kStopped);
}

bool Child::has_ended() {
  if (pid_ < 0) return true;
  int status = 0;
  rusage used{};
  if (wait4(pid_, &status, WNOHANG, &used) == 0) {
    const std::int64_t memory = memory_now();
    done_.peak_memory_bytes = std::max(done_.peak_memory_bytes, memory);
    if (seconds() > timeout_s_) end_for(ChildEnd::kTimeout);
    if (memory_bytes_ > 0 && memory > memory_bytes_) end_for(ChildEnd::kMemory);
    if (ending_ && Clock::now() - told_ > std::chrono::duration<double>(kGraceSeconds))
      kill(pid_, SIGKILL);
    return false;
  }
  kill(-pid_, SIGKILL);  // what it started itself
  pid_ = -1;
  done_.wall_s = seconds();
  // In KiB. Before the child became the program it was a copy of this one.
  done_.peak_memory_bytes = std::max(done_.peak_memory_bytes, std::int64_t{1024} * used.ru_maxrss);
  done_.end = ending_ ? reason_ : WIFSIGNALED(status) ? ChildEnd::kSignal : ChildEnd::kExit;
  done_.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
  return true;
}

}  // namespace pentimento
