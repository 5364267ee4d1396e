#include "formats/io/stream_write.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <future>
#include <string>
#include <thread>

namespace pentimento {
namespace {

/// A pipe holds 64 KiB.
std::string more_than_a_pipe_holds() {
  std::string bytes(300'001, ' ');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * i % 251);
  return bytes;
}

/// A pipe; `flags` are those of both ends.
struct StreamPipe {
  explicit StreamPipe(int flags = 0) { EXPECT_EQ(::pipe2(ends, flags), 0); }
  ~StreamPipe() {
    for (const int end : ends) ::close(end);
  }
  StreamPipe(const StreamPipe&) = delete;
  StreamPipe& operator=(const StreamPipe&) = delete;
  int ends[2] = {-1, -1};
};

/// While it lives, SIGUSR1 is listened to, and SIGPIPE does not end the process.
class ListenedTo {
 public:
  ListenedTo() {
    struct sigaction action {};
    action.sa_handler = [](int) {};
    sigemptyset(&action.sa_mask);
    sigaction(SIGUSR1, &action, &before_);
    pipe_before_ = std::signal(SIGPIPE, SIG_IGN);
  }
  ~ListenedTo() {
    sigaction(SIGUSR1, &before_, nullptr);
    std::signal(SIGPIPE, pipe_before_);
  }
  ListenedTo(const ListenedTo&) = delete;
  ListenedTo& operator=(const ListenedTo&) = delete;

 private:
  struct sigaction before_ {};
  void (*pipe_before_)(int) = nullptr;
};

std::string read_all(int descriptor, std::size_t count) {
  std::string bytes(count, '\0');
  std::size_t filled = 0;
  while (filled < count) {
    const ssize_t n = ::read(descriptor, bytes.data() + filled, count - filled);
    if (n < 0 && errno == EAGAIN) std::this_thread::yield();
    if (n > 0) filled += static_cast<std::size_t>(n);
    if (n == 0) break;
  }
  bytes.resize(filled);
  return bytes;
}

TEST(StreamWrite, AllBytesArriveAtAReader) {
  for (const int flags : {0, O_NONBLOCK}) {
    const StreamPipe pipe(flags);
    const std::string bytes = more_than_a_pipe_holds();
    std::future<std::string> read =
        std::async(std::launch::async, [&] { return read_all(pipe.ends[0], bytes.size()); });
    EXPECT_EQ(write_to_stream(pipe.ends[1], bytes.data(), bytes.size()), 0);
    EXPECT_EQ(read.get(), bytes);
  }
}

TEST(StreamWrite, ASignalEndsTheWaitForAReaderAfterAPartWasWritten) {
  const ListenedTo signals;
  for (const int flags : {0, O_NONBLOCK}) {
    const StreamPipe pipe(flags);
    const std::string bytes = more_than_a_pipe_holds();
    std::promise<int> result;
    std::future<int> ended = result.get_future();
    std::thread writer(
        [&] { result.set_value(write_to_stream(pipe.ends[1], bytes.data(), bytes.size())); });
    std::this_thread::sleep_for(std::chrono::milliseconds(100));  // by then the pipe is full
    pthread_kill(writer.native_handle(), SIGUSR1);
    if (ended.wait_for(std::chrono::seconds(5)) != std::future_status::ready)
      read_all(pipe.ends[0], bytes.size());  // it waits on: let it go
    writer.join();
    EXPECT_EQ(ended.get(), EINTR);
  }
}

TEST(StreamWrite, AReaderThatIsGoneIsAnError) {
  const ListenedTo signals;
  StreamPipe pipe;
  ::close(pipe.ends[0]);
  pipe.ends[0] = -1;
  EXPECT_EQ(write_to_stream(pipe.ends[1], "abc", 3), EPIPE);
}

}  // namespace
}  // namespace pentimento
