#pragma once
// For tests of what is done when the machine refuses: a disk that says which calls fail of the
// functions of faulty_disk.cpp, which stand in front of the C library's for the whole test
// programme.

#include <cstddef>
#include <map>
#include <string>
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

}  // namespace pentimento::test
