#include "formats/hdf5/rehearsal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace pentimento::hdf5 {

namespace {
constexpr int kRight = 0, kWrong = 77;        // exit codes of the child
constexpr rlim_t kMostSeconds = 300;          // a small file that decompresses to 15 GB takes half
constexpr rlim_t kLeastBytesPerSecond = 1e7;  // beyond that

/// Processor time that reading the file may take.
rlim_t most_seconds(const std::string& path) {
  std::error_code unknown;
  const std::uintmax_t bytes = std::filesystem::file_size(path, unknown);
  return kMostSeconds + (unknown ? 0 : bytes / kLeastBytesPerSecond);
}

[[noreturn]] void read_and_leave(const std::string& path, const std::function<bool()>& read) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL}) ::signal(signal, SIG_DFL);
  const rlimit no_core = {0, 0};
  const rlimit time = {most_seconds(path), most_seconds(path)};
  setrlimit(RLIMIT_CORE, &no_core);
  setrlimit(RLIMIT_CPU, &time);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) dup2(nowhere, STDERR_FILENO);
  _exit(read() ? kRight : kWrong);
}
}  // namespace

Result<bool> rehearse(const std::string& path, const std::function<bool()>& read) {
  const pid_t child = fork();
  if (child < 0)
    return Error{ErrorCode::kIo,
                 fmt::format("{}: no child process to read it: {}", path, std::strerror(errno))};
  if (child == 0) read_and_leave(path, read);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == kRight) return true;
  if (WIFEXITED(status) && WEXITSTATUS(status) == kWrong) return false;
  return Error{ErrorCode::kBadInput, path + ": a damaged HDF5 file"};
}

}  // namespace pentimento::hdf5
