// The functions that tests of a refusing machine put in front of the C library's. They are no weak
// ones: those of a sanitizer are, and would come first.

#include "tests/formats/faulty_disk.h"

#include <dlfcn.h>
#include <sys/file.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

namespace pentimento::test {
namespace {

std::string file_of(int descriptor) {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor), error)
      .string();
}

void note(const std::string& call) {
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

}  // namespace
}  // namespace pentimento::test

using pentimento::test::Fault;
using pentimento::test::FaultyDisk;
using pentimento::test::file_of;
using pentimento::test::meet;
using pentimento::test::meet_read;
using pentimento::test::next_one;
using pentimento::test::note;

extern "C" {
int fsync(int file) {
  note("fsync " + file_of(file));
  return meet("fsync", [&](const Fault&) {
    static auto* const real = next_one<int(int)>("fsync");
    return real(file);
  });
}
int rename(const char* from, const char* to) noexcept {
  note(std::string("name ").append(from).append(" ").append(to));
  return meet("rename", [&](const Fault&) {
    static auto* const real = next_one<int(const char*, const char*)>("rename");
    return real(from, to);
  });
}
int link(const char* from, const char* to) noexcept {
  note(std::string("name ").append(from).append(" ").append(to));
  return meet("link", [&](const Fault&) {
    static auto* const real = next_one<int(const char*, const char*)>("link");
    return real(from, to);
  });
}
ssize_t write(int file, const void* bytes, size_t count) {
  return meet("write", [&](const Fault& fault) {
    static auto* const real = next_one<ssize_t(int, const void*, size_t)>("write");
    return real(file, bytes, std::min(count, fault.most));
  });
}
ssize_t read(int file, void* bytes, size_t count) {
  return meet_read("read", bytes, [&](const Fault& fault) {
    static auto* const real = next_one<ssize_t(int, void*, size_t)>("read");
    return real(file, bytes, std::min(count, fault.most));
  });
}
ssize_t pread(int file, void* bytes, size_t count, off_t offset) {
  return meet_read("pread", bytes, [&](const Fault& fault) {
    static auto* const real = next_one<ssize_t(int, void*, size_t, off_t)>("pread");
    return real(file, bytes, std::min(count, fault.most), offset);
  });
}
off_t lseek(int file, off_t offset, int from) noexcept {
  return meet("lseek", [&](const Fault&) {
    static auto* const real = next_one<off_t(int, off_t, int)>("lseek");
    return real(file, offset, from);
  });
}
int ftruncate(int file, off_t bytes) noexcept {
  return meet("ftruncate", [&](const Fault&) {
    static auto* const real = next_one<int(int, off_t)>("ftruncate");
    return real(file, bytes);
  });
}
int flock(int file, int how) noexcept {
  return meet("flock", [&](const Fault&) {
    static auto* const real = next_one<int(int, int)>("flock");
    return real(file, how);
  });
}
/// Does not sleep at all while a disk is watched.
int nanosleep(const timespec* time, timespec* rest) {
  return meet("nanosleep", [&](const Fault&) {
    if (FaultyDisk::current() != nullptr) return 0;
    static auto* const real = next_one<int(const timespec*, timespec*)>("nanosleep");
    return real(time, rest);
  });
}
}
