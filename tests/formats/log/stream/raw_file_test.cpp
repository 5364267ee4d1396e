#include "formats/log/stream/raw_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "formats/log/stream/line_source.h"
#include "tests/formats/faulty_disk.h"
#include "tests/formats/scratch.h"

namespace pentimento::log {
namespace {

/// A pipe with a name, and a writer that writes until it is no longer read.
class EndlessPipe {
 public:
  explicit EndlessPipe(std::string block) : path_(scratch_.path("pipe")), block_(std::move(block)) {
    std::signal(SIGPIPE, SIG_IGN);
    EXPECT_EQ(::mkfifo(path_.c_str(), 0600), 0);
    writer_ = std::thread([this] {
      const int file = ::open(path_.c_str(), O_WRONLY);
      for (ssize_t n = 0; (n = ::write(file, block_.data(), block_.size())) > 0;) written_ += n;
      ::close(file);
    });
  }
  ~EndlessPipe() { writer_.join(); }
  EndlessPipe(const EndlessPipe&) = delete;
  EndlessPipe& operator=(const EndlessPipe&) = delete;
  const std::string& path() const { return path_; }
  std::int64_t written() const { return written_; }

 private:
  test::Scratch scratch_;
  std::string path_, block_;
  std::atomic<std::int64_t> written_{0};
  std::thread writer_;
};

TEST(RawFile, OfAPipeNoMoreIsReadThanWanted) {
  const EndlessPipe pipe("0123456789");
  const auto file = RawFile::open(pipe.path());
  ASSERT_TRUE(file);
  char bytes[30];
  EXPECT_EQ((*file)->read(bytes).value(), 30u);
  EXPECT_LE(pipe.written(), 200'000);  // what the pipe itself holds, and these
  ASSERT_TRUE((*file)->rewind());
  char again[25];
  EXPECT_EQ((*file)->read(again).value(), 25u);
  EXPECT_EQ(std::string(again, 25), "0123456789012345678901234");
  EXPECT_EQ((*file)->read(bytes).value(), 30u);  // five from the copy, the others from the pipe
  EXPECT_EQ(std::string(bytes, 30), "567890123456789012345678901234");
}

TEST(RawFile, APipeWithoutEndIsOverALimit) {
  const EndlessPipe pipe(std::string(1000, 'x'));
  ReaderOptions options;
  options.limits.max_bytes = 100'000;
  const auto file = RawFile::open(pipe.path(), options);
  ASSERT_TRUE(file);
  std::string bytes(200'000, '\0');
  const auto read = (*file)->read(bytes);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::kLimit);
  EXPECT_NE(read.error().message.find("--limit bytes=N"), std::string::npos);
}

TEST(RawFile, WaitingForAPipeEndsWithTheFlag) {
  const test::Scratch scratch;
  const std::string path = scratch.path("silent");
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  std::atomic<bool> cancelled{false};
  ReaderOptions options;
  options.cancelled = &cancelled;
  const auto file = RawFile::open(path, options);
  ASSERT_TRUE(file);
  std::thread signal([&] { cancelled = true; });
  char bytes[1];
  const auto read = (*file)->read(bytes);
  signal.join();
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::kInterrupted);
}

TEST(RawFile, WhatWasInterruptedOrCutShortGoesOn) {
  const test::Scratch scratch;
  test::spill(scratch.path("a"), "0123456789");
  const auto file = RawFile::open(scratch.path("a"));
  ASSERT_TRUE(file);
  test::FaultyDisk disk;
  disk.plan("read", 1, {EINTR});
  disk.plan("read", 2, {EAGAIN});
  disk.plan("read", 3, {0, 3});
  std::string bytes(10, ' ');
  EXPECT_EQ((*file)->read(bytes).value(), 10u);
  EXPECT_EQ(bytes, "0123456789");
  EXPECT_EQ(disk.calls("read"), 4);
}

TEST(RawFile, SaysWhatTheMachineRefuses) {
  const test::Scratch scratch;
  const std::string path = scratch.path("a");
  EXPECT_EQ(RawFile::open(path).error().message,
            path + ": cannot be opened: No such file or directory");
  EXPECT_EQ(RawFile::open(scratch.path("")).error().message,
            scratch.path("") + ": cannot be read: Is a directory");
  test::spill(path, "0123456789");
  const auto file = RawFile::open(path);
  ASSERT_TRUE(file);
  test::FaultyDisk disk;
  disk.plan("read", 1, {EIO});
  std::string bytes(10, ' ');
  const auto read = (*file)->read(bytes);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::kIo);
  EXPECT_EQ(read.error().message, path + ": cannot be read: Input/output error");
  disk.plan("lseek", 1, {ESPIPE});
  EXPECT_EQ((*file)->rewind().error().message, path + ": cannot be read again: Illegal seek");
}

TEST(RawFile, OfAPipeNeedsRoomForItsCopy) {
  const test::Scratch scratch;
  const std::string path = scratch.path("pipe");
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  const int writer = ::open(path.c_str(), O_RDWR);  // keeps it open, so that it does not end
  ASSERT_EQ(::write(writer, "0123456789", 10), 10);
  const auto file = RawFile::open(path);
  ASSERT_TRUE(file);
  std::string bytes(5, ' ');
  {
    test::FaultyDisk disk;
    disk.plan("write", 1, {EINTR});
    disk.plan("write", 2, {0, 2});
    EXPECT_EQ((*file)->read(bytes).value(), 5u);
    EXPECT_EQ(disk.calls("write"), 3);
    ASSERT_TRUE((*file)->rewind());
    disk.plan("pread", 1, {EINTR});
    EXPECT_EQ((*file)->read(bytes).value(), 5u);
    EXPECT_EQ(bytes, "01234");
    disk.always("write", ENOSPC);
    const auto full = (*file)->read(bytes);
    ASSERT_FALSE(full);
    EXPECT_EQ(full.error().code, ErrorCode::kIo);
    EXPECT_EQ(full.error().message,
              path + ": its temporary copy cannot be written: No space left on device");
    ASSERT_TRUE((*file)->rewind());
    disk.plan("pread", 1, {EIO});
    EXPECT_EQ((*file)->read(bytes).error().message,
              path + ": its temporary copy cannot be read: Input/output error");
  }
  ::setenv("TMPDIR", scratch.path("none").c_str(), 1);
  EXPECT_EQ(RawFile::open(path).error().message,
            path + ": no temporary file to keep it in: No such file or directory");
  ::unsetenv("TMPDIR");
  ::close(writer);
}

TEST(LineSource, BlankLinesAndBytesAreBounded) {
  const test::Scratch scratch;
  test::spill(scratch.path("feeds"), "a\n" + std::string(100, '\n') + "b\n");
  ReaderOptions options;
  const auto second_line = [&] {
    LineSource lines(std::move(*ByteSource::open(scratch.path("feeds"), options)), options);
    EXPECT_TRUE(lines.next().value());
    const auto line = lines.next();
    return line ? std::string((*line)->text) : line.error().message;
  };
  EXPECT_EQ(second_line(), "b");
  options.limits.max_events = 100;
  EXPECT_EQ(second_line(), "b");
  options.limits.max_events = 99;
  EXPECT_EQ(second_line(), "more than 99 blank lines, the limit (--max-events)");
  options.limits.max_events = 100;
  options.limits.max_bytes = 103;
  LineSource lines(std::move(*ByteSource::open(scratch.path("feeds"), options)), options);
  EXPECT_EQ(lines.next().error().message, "more than 103 bytes, the limit (--limit bytes=N)");
}

TEST(LineSource, HearsAnInterruptionWhileItIsReadFirst_AndNotAgain) {
  const test::Scratch scratch;
  // Longer than what is read at a time, so that the flag falls between two reads.
  test::spill(scratch.path("long"), std::string(5'000'000, 'x') + "\nb\n");
  std::atomic<bool> cancelled{false};
  ReaderOptions options;
  options.cancelled = &cancelled;
  LineSource lines(std::move(*ByteSource::open(scratch.path("long"))), options);
  cancelled = true;
  const auto interrupted = lines.next();
  ASSERT_FALSE(interrupted);
  EXPECT_EQ(interrupted.error().code, ErrorCode::kInterrupted);
  cancelled = false;
  ASSERT_TRUE(lines.rewind());
  while (lines.next().value()) {
  }
  cancelled = true;
  ASSERT_TRUE(lines.rewind());
  EXPECT_TRUE(lines.next()) << "its length is known: it ends by itself";
}

}  // namespace
}  // namespace pentimento::log
