#include "formats/hdf5/rehearsal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <optional>

#include "core/base/interruption.h"

namespace pentimento::hdf5 {

namespace {

// What the child writes into the pipe: records of a letter, a number, and for an error its message.
constexpr char kExpects = 'e', kFails = 'f', kSucceeds = 's';
constexpr std::size_t kMostReport = 4096;  // bytes that the parent takes of the last record
constexpr int kMostWaitMs = 50;            // between two looks at `cancelled` and at the clock

struct ChildNote {
  char kind = 0;
  std::uint64_t number = 0;  // bytes that are read, or the code of the error
};

void send(int pipe, const void* bytes, std::size_t count) {
  while (write(pipe, bytes, count) < 0 && errno == EINTR) {
  }
}

/// Address space that this process has; 0 if it is not known.
rlim_t address_space() {
  std::FILE* file = std::fopen("/proc/self/statm", "re");
  if (file == nullptr) return 0;
  unsigned long long pages = 0;
  const int read = std::fscanf(file, "%llu", &pages);
  std::fclose(file);
  return read == 1 ? static_cast<rlim_t>(pages) * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) : 0;
}

/// A limit of the user's stays as the hard one.
void limit_memory(std::uint64_t bytes) {
  rlimit memory{};
  const rlim_t taken = address_space();
  if (taken == 0 || getrlimit(RLIMIT_AS, &memory) != 0) return;
  memory.rlim_cur = std::min<rlim_t>(memory.rlim_cur, taken + bytes);
  setrlimit(RLIMIT_AS, &memory);
}

Result<void> read_without_throwing(const Rehearsal& rehearsal,
                                   const std::function<Result<void>(const Rehearsal&)>& read,
                                   const std::string& path) {
  try {
    return read(rehearsal);
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::kLimit, path + ": no memory to read it"};
  } catch (const std::exception&) {
    return Error{ErrorCode::kBadInput, path + ": a damaged HDF5 file"};
  }
}

[[noreturn]] void read_and_leave(int pipe, pid_t parent, const std::string& path,
                                 const std::function<Result<void>(const Rehearsal&)>& read,
                                 const RehearsalLimits& limits) {
  // Asked for the signal too late if the parent has ended since the fork.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL}) ::signal(signal, SIG_DFL);
  // The terminal sends these to both; the parent decides.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::signal(signal, SIG_IGN);
  const rlimit nothing = {0, 0};
  setrlimit(RLIMIT_CORE, &nothing);
  setrlimit(RLIMIT_FSIZE, &nothing);  // it has nothing to write
  limit_memory(limits.bytes);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) dup2(nowhere, STDERR_FILENO);
  const Result<void> done = read_without_throwing(Rehearsal(pipe), read, path);
  ChildNote record{kSucceeds, 0};
  if (!done) record = {kFails, static_cast<std::uint64_t>(done.error().code)};
  send(pipe, &record, sizeof record);
  if (!done)
    send(pipe, done.error().message.data(), std::min(kMostReport, done.error().message.size()));
  _exit(0);
}

/// The child as its parent sees it. Kills it if it runs.
class WatchedChild {
 public:
  using Clock = std::chrono::steady_clock;
  WatchedChild(pid_t pid, int pipe, const RehearsalLimits& limits)
      : pid_(pid), pipe_(pipe), limits_(limits), began_(Clock::now()), seconds_(limits.seconds) {}
  ~WatchedChild() {
    close(pipe_);
    if (pid_ < 0) return;
    kill(pid_, SIGKILL);
    while (waitpid(pid_, &status_, 0) < 0 && errno == EINTR) {
    }
  }
  WatchedChild(const WatchedChild&) = delete;
  WatchedChild& operator=(const WatchedChild&) = delete;

  /// Waits a moment. False once the child has ended and all that it said is taken.
  bool runs() {
    pollfd waiting = {heard_all_ ? -1 : pipe_, POLLIN, 0};
    poll(&waiting, 1, heard_all_ ? 1 : kMostWaitMs);
    const pid_t ended = waitpid(pid_, &status_, WNOHANG);
    take();
    if (ended != pid_) return true;
    pid_ = -1;
    return false;
  }
  bool late() const {
    return std::chrono::duration<double>(Clock::now() - began_).count() > seconds_;
  }
  double seconds() const { return seconds_; }
  /// What the ended child said. nullopt if it died.
  std::optional<Result<void>> said() const {
    const bool whole = WIFEXITED(status_) && WEXITSTATUS(status_) == 0;
    if (!whole || (last_.kind != kSucceeds && last_.kind != kFails)) return std::nullopt;
    if (last_.kind == kSucceeds) return Result<void>();
    if (last_.number > static_cast<std::uint64_t>(ErrorCode::kInterrupted)) return std::nullopt;
    return Result<void>(Error{static_cast<ErrorCode>(last_.number), text_});
  }

 private:
  /// Takes what is in the pipe, which does not wait.
  void take() {
    char bytes[512];
    ssize_t count = 0;
    while (!heard_all_ && (count = read(pipe_, bytes, sizeof bytes)) > 0)
      text_.append(bytes, static_cast<std::size_t>(count));
    heard_all_ = heard_all_ || count == 0;
    while (last_.kind != kFails && text_.size() >= sizeof last_) {
      std::memcpy(&last_, text_.data(), sizeof last_);
      text_.erase(0, sizeof last_);
      if (last_.kind == kExpects)
        seconds_ += static_cast<double>(last_.number) / limits_.bytes_per_second;
    }
    if (text_.size() > kMostReport) heard_all_ = true;
  }

  pid_t pid_;
  int pipe_;
  RehearsalLimits limits_;
  Clock::time_point began_;
  double seconds_;  // that it may take
  int status_ = 0;
  bool heard_all_ = false;
  ChildNote last_;
  std::string text_;  // that belongs to no record yet; after kFails the message
};

}  // namespace

void Rehearsal::expect(std::uint64_t bytes, std::uint64_t held_bytes) const {
  if (real()) return;
  const ChildNote record{kExpects, bytes};
  send(pipe_, &record, sizeof record);
  rlimit memory{};
  if (getrlimit(RLIMIT_AS, &memory) != 0 || memory.rlim_cur == RLIM_INFINITY) return;
  memory.rlim_cur = std::min<rlim_t>(memory.rlim_max, memory.rlim_cur + held_bytes);
  setrlimit(RLIMIT_AS, &memory);
}

Result<void> rehearse(const std::string& path, const std::atomic<bool>* cancelled,
                      const std::function<Result<void>(const Rehearsal&)>& read,
                      const RehearsalLimits& limits) {
  const auto not_started = [&] {
    return Error{ErrorCode::kIo,
                 fmt::format("{}: no child process to read it: {}", path, std::strerror(errno))};
  };
  int ends[2] = {-1, -1};
  if (pipe2(ends, O_CLOEXEC) != 0) return not_started();
  // What waits in buffers of stdio would be in the child's, too, and a sanitizer writes them out.
  std::fflush(nullptr);
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    read_and_leave(ends[1], parent, path, read, limits);
  }
  close(ends[1]);
  if (child < 0) {
    const Error error = not_started();
    close(ends[0]);
    return error;
  }
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  WatchedChild watched(child, ends[0], limits);
  while (watched.runs()) {
    if (Result<void> go = unless_interrupted(cancelled); !go) return go;
    if (watched.late())
      return Error{ErrorCode::kBadInput,
                   fmt::format("{}: not read within {:.0f} s: damaged, or made to take long", path,
                               watched.seconds())};
  }
  return watched.said().value_or(Error{ErrorCode::kBadInput, path + ": a damaged HDF5 file"});
}

}  // namespace pentimento::hdf5
