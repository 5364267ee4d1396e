#pragma once
// Work that goes on beside the thread that began it, one piece at a time.

#include <exception>
#include <functional>
#include <optional>
#include <thread>

namespace pentimento {

class SideWork {
 public:
  SideWork() = default;
  /// Waits; what the work throws is lost.
  ~SideWork();
  SideWork(const SideWork&) = delete;
  SideWork& operator=(const SideWork&) = delete;

  /// Waits for the piece of work before, then begins `work` on a thread of its own. If the machine
  /// gives none, the caller does it at once.
  void begin(std::function<void()> work);
  /// Returns when the work is done. What it threw is thrown here, once.
  void wait();

 private:
  void join();

  std::optional<std::thread::native_handle_type> thread_;
  std::exception_ptr problem_;
};

}  // namespace pentimento
