#pragma once
// For tests of what is done when HDF5 refuses: one of its calls fails. The functions of
// faulty_hdf5.cpp stand in front of the library's for the whole test programme.

#include <unistd.h>

#include <map>
#include <string>

namespace pentimento::test {

/// While it lives, calls are counted by their names, and one fails. One at a time, in tests of one
/// thread.
class FaultyHdf5 {
 public:
  /// The `number`-th call of `call` fails, from 1; 0: none. With `here`, only calls of this process
  /// count, and not those of its children.
  explicit FaultyHdf5(std::string call = "", int number = 0, bool here = false)
      : call_(std::move(call)), number_(number), process_(here ? ::getpid() : 0) {
    current() = this;
  }
  ~FaultyHdf5() { current() = nullptr; }
  FaultyHdf5(const FaultyHdf5&) = delete;
  FaultyHdf5& operator=(const FaultyHdf5&) = delete;
  static FaultyHdf5*& current() {
    static FaultyHdf5* faulty = nullptr;
    return faulty;
  }

  int calls(const std::string& call) const {
    const auto found = calls_.find(call);
    return found == calls_.end() ? 0 : found->second;
  }
  /// For the functions that stand in front: whether this call fails.
  static bool fails(const std::string& call) {
    FaultyHdf5* faulty = current();
    if (faulty == nullptr || (faulty->process_ != 0 && faulty->process_ != ::getpid()))
      return false;
    return ++faulty->calls_[call] == faulty->number_ && call == faulty->call_;
  }

 private:
  std::string call_;
  int number_;
  pid_t process_;
  std::map<std::string, int> calls_;
};

}  // namespace pentimento::test
