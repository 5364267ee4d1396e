#pragma once
// For tests of what is done when the machine refuses: functions that stand in front of the C
// library's for the whole test programme, and a disk that says which of their calls fail.

#include <dlfcn.h>
#include <sys/file.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <system_error>
#include <vector>

namespace pentimento::test {

/// What becomes of one call.
struct Fault {
  int error_number = 0;     // the call fails with it; 0: it does not fail
  std::size_t most = ~0UL;  // bytes that are moved at most; what is not moved is not lost
  bool flips = false;       // the first byte that is read is another than the one on the disk
};

/// While it lives it sees the calls by which a file is written, read, locked and named, and decides
/// what becomes of them. One at a time, in tests of one thread.
class FaultyDisk {
 public:
  FaultyDisk() { current() = this; }
  ~FaultyDisk() { current() = nullptr; }
  FaultyDisk(const FaultyDisk&) = delete;
  FaultyDisk& operator=(const FaultyDisk&) = delete;
  static FaultyDisk*& current() {
    static FaultyDisk* disk = nullptr;
    return disk;
  }

  /// The `number`-th call from now, from 1, meets the fault.
  void plan(const std::string& call, int number, Fault fault) {
    once_[call][calls_[call] + number] = fault;
  }
  /// Every call from now on fails.
  void always(const std::string& call, int error_number) { always_[call] = {error_number}; }
  /// How often a function was called.
  int calls(const std::string& call) const {
    const auto found = calls_.find(call);
    return found == calls_.end() ? 0 : found->second;
  }
  /// The calls by which files reach the disk and get their names, in their order.
  std::vector<std::string> noted;

  /// For the functions below: counts a call and answers with its fault.
  static Fault meet(const char* call) {
    FaultyDisk* disk = current();
    return disk == nullptr ? Fault() : disk->next(call);
  }

 private:
  Fault next(const std::string& call) {
    const int number = ++calls_[call];
    const std::map<int, Fault>& plans = once_[call];
    if (const auto found = plans.find(number); found != plans.end()) return found->second;
    const auto found = always_.find(call);
    return found == always_.end() ? Fault() : found->second;
  }

  std::map<std::string, int> calls_;
  std::map<std::string, std::map<int, Fault>> once_;
  std::map<std::string, Fault> always_;
};

inline std::string file_of(int descriptor) {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor), error)
      .string();
}

inline void note(const std::string& call) {
  if (FaultyDisk* disk = FaultyDisk::current()) disk->noted.push_back(call);
}

template <typename Function>
Function* next_one(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

/// Calls the C library's function by way of `call`, or fails as planned.
template <typename Call>
auto meet(const char* name, const Call& call) -> decltype(call(Fault())) {
  const Fault fault = FaultyDisk::meet(name);
  if (fault.error_number == 0) return call(fault);
  errno = fault.error_number;
  return -1;
}

template <typename Call>
ssize_t meet_read(const char* name, void* bytes, const Call& call) {
  return meet(name, [&](const Fault& fault) {
    const ssize_t count = call(fault);
    if (fault.flips && count > 0) *static_cast<unsigned char*>(bytes) ^= 1U;
    return count;
  });
}

}  // namespace pentimento::test

// Weak, so that every test that wants them may include this file.
extern "C" {
[[gnu::weak]] int fsync(int file) {
  pentimento::test::note("fsync " + pentimento::test::file_of(file));
  return pentimento::test::meet("fsync", [&](const pentimento::test::Fault&) {
    static auto* const real = pentimento::test::next_one<int(int)>("fsync");
    return real(file);
  });
}
[[gnu::weak]] int rename(const char* from, const char* to) noexcept {
  pentimento::test::note(std::string("name ").append(from).append(" ").append(to));
  return pentimento::test::meet("rename", [&](const pentimento::test::Fault&) {
    static auto* const real = pentimento::test::next_one<int(const char*, const char*)>("rename");
    return real(from, to);
  });
}
[[gnu::weak]] int link(const char* from, const char* to) noexcept {
  pentimento::test::note(std::string("name ").append(from).append(" ").append(to));
  return pentimento::test::meet("link", [&](const pentimento::test::Fault&) {
    static auto* const real = pentimento::test::next_one<int(const char*, const char*)>("link");
    return real(from, to);
  });
}
[[gnu::weak]] ssize_t write(int file, const void* bytes, size_t count) {
  return pentimento::test::meet("write", [&](const pentimento::test::Fault& fault) {
    static auto* const real =
        pentimento::test::next_one<ssize_t(int, const void*, size_t)>("write");
    return real(file, bytes, std::min(count, fault.most));
  });
}
[[gnu::weak]] ssize_t read(int file, void* bytes, size_t count) {
  return pentimento::test::meet_read("read", bytes, [&](const pentimento::test::Fault& fault) {
    static auto* const real = pentimento::test::next_one<ssize_t(int, void*, size_t)>("read");
    return real(file, bytes, std::min(count, fault.most));
  });
}
[[gnu::weak]] ssize_t pread(int file, void* bytes, size_t count, off_t offset) {
  return pentimento::test::meet_read("pread", bytes, [&](const pentimento::test::Fault& fault) {
    static auto* const real =
        pentimento::test::next_one<ssize_t(int, void*, size_t, off_t)>("pread");
    return real(file, bytes, std::min(count, fault.most), offset);
  });
}
[[gnu::weak]] off_t lseek(int file, off_t offset, int from) noexcept {
  return pentimento::test::meet("lseek", [&](const pentimento::test::Fault&) {
    static auto* const real = pentimento::test::next_one<off_t(int, off_t, int)>("lseek");
    return real(file, offset, from);
  });
}
[[gnu::weak]] int ftruncate(int file, off_t bytes) noexcept {
  return pentimento::test::meet("ftruncate", [&](const pentimento::test::Fault&) {
    static auto* const real = pentimento::test::next_one<int(int, off_t)>("ftruncate");
    return real(file, bytes);
  });
}
[[gnu::weak]] int flock(int file, int how) noexcept {
  return pentimento::test::meet("flock", [&](const pentimento::test::Fault&) {
    static auto* const real = pentimento::test::next_one<int(int, int)>("flock");
    return real(file, how);
  });
}
/// Does not sleep at all while a disk is watched.
[[gnu::weak]] int nanosleep(const timespec* time, timespec* rest) {
  return pentimento::test::meet("nanosleep", [&](const pentimento::test::Fault&) {
    if (pentimento::test::FaultyDisk::current() != nullptr) return 0;
    static auto* const real =
        pentimento::test::next_one<int(const timespec*, timespec*)>("nanosleep");
    return real(time, rest);
  });
}
}
