#pragma once
// Memory for the tiles of a large canvas: buffers of floats, all of one size. They lie in anonymous
// memory, or in a file to which the operating system may move them; the file has no name, so
// nothing is left behind. A buffer keeps its address until it is freed. All functions but trim()
// may be called from several threads at once.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace pentimento {

struct TileStoreOptions {
  std::size_t buffer_floats = 128 * 128;
  std::string scratch;              // a folder; empty: anonymous memory
  std::int64_t resident_bytes = 0;  // how much of it trim() leaves in memory; 0 = all
};

class TileStore {
 public:
  using Buffer = std::uint32_t;

  /// Opens a store. It reserves nothing before the first allocate(). Errors: kIo (the folder takes
  /// no file).
  static Result<std::unique_ptr<TileStore>> open(const TileStoreOptions& options);
  ~TileStore();
  TileStore(const TileStore&) = delete;
  TileStore& operator=(const TileStore&) = delete;

  /// A buffer of zeros, which counts as used now. Its space is reserved here, so that no later
  /// write can fail. Errors: kLimit (no memory), kIo (the disk of the scratch folder is full or
  /// fails).
  Result<Buffer> allocate();
  /// Gives the buffer all its memory now. Else the system gives a page when it is touched, and one
  /// that is read before it is written twice: first a page of zeros that all share, then one of its
  /// own, for which it interrupts all other threads. In a file nothing is done.
  void give_memory(Buffer buffer);
  /// Gives back the buffer's memory, and in a scratch file its space on the disk. allocate() may
  /// give the same buffer again.
  void free(Buffer buffer);
  /// The buffer's floats, TileStoreOptions::buffer_floats of them. They start at a page.
  float* data(Buffer buffer) const;

  /// Whether trim() ever gives memory back, so that it has to know which buffers are used.
  bool gives_back() const { return file_ >= 0 && options_.resident_bytes > 0; }
  /// Notes that the buffer is in use now. Where trim() gives nothing back, it does nothing.
  void mark_used(Buffer buffer) {
    if (gives_back()) note_use(buffer);
  }
  /// Gives back memory until only resident_bytes are held, beginning with the buffers that were
  /// used longest ago. Buffers used between the same two calls of trim() count as equally old.
  /// Their values stay in the file. Call it while no thread works on buffers. Without a scratch
  /// folder or a budget it does nothing.
  void trim();

  std::int64_t buffers() const { return used_.load(); }
  /// Bytes of all buffers, wherever they are.
  std::int64_t bytes() const { return used_.load() * static_cast<std::int64_t>(stride_); }
  /// Bytes of the buffers that count as held in memory: those used since their memory was given
  /// back.
  std::int64_t held_bytes() const { return held_.load() * static_cast<std::int64_t>(stride_); }

 private:
  using LastUse = std::atomic<std::uint64_t>;  // trims done when last touched, from 1; 0 = not held
  struct MemorySegment {
    char* base = nullptr;
    std::unique_ptr<LastUse[]> last_use;  // per buffer
  };
  explicit TileStore(const TileStoreOptions& options);
  Result<void> open_file();
  Result<void> add_segment();
  Result<void> reserve(std::int64_t offset, std::size_t bytes) const;
  LastUse& last_use_of(Buffer buffer) const {
    return segments_[buffer / segment_buffers_].last_use[buffer % segment_buffers_];
  }
  std::int64_t offset_of(Buffer buffer) const {
    return static_cast<std::int64_t>(buffer) * static_cast<std::int64_t>(stride_);
  }
  void note_use(Buffer buffer);
  void drop(Buffer buffer) const;

  TileStoreOptions options_;
  std::size_t stride_;  // bytes of a buffer, whole pages
  std::uint32_t segment_buffers_;
  int file_ = -1;  // -1: anonymous
  std::mutex mutex_;
  std::vector<MemorySegment> segments_;  // as many as there may ever be, so that none moves
  std::size_t mapped_ = 0;               // segments that exist
  std::vector<Buffer> free_;
  Buffer next_ = 0;  // first buffer never handed out
  std::atomic<std::int64_t> used_{0}, held_{0};
  std::uint64_t trims_ = 1;
};

}  // namespace pentimento
