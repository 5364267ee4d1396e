#include "core/canvas/tile_store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "core/base/check.h"

namespace pentimento {
namespace {

constexpr std::size_t kSegmentBytes = std::size_t{64} << 20;  // grown in steps of this
constexpr std::size_t kMostSegments = 32768;                  // 2 TiB

std::size_t whole_pages(std::size_t bytes) {
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  return (bytes + page - 1) / page * page;
}

Error scratch_error(const std::string& folder, int error_number) {
  return {ErrorCode::kIo, fmt::format("--scratch {}: {}", folder, std::strerror(error_number))};
}

}  // namespace

TileStore::TileStore(const TileStoreOptions& options)
    : options_(options),
      stride_(whole_pages(options.buffer_floats * sizeof(float))),
      segment_buffers_(
          static_cast<std::uint32_t>(std::max<std::size_t>(1, kSegmentBytes / stride_))),
      segments_(kMostSegments) {
  PENTIMENTO_CHECK(options.buffer_floats > 0);
}

TileStore::~TileStore() {
  for (std::size_t i = 0; i < mapped_; ++i) munmap(segments_[i].base, segment_buffers_ * stride_);
  if (file_ >= 0) close(file_);
}

Result<std::unique_ptr<TileStore>> TileStore::open(const TileStoreOptions& options) {
  std::unique_ptr<TileStore> store(new TileStore(options));
  if (options.scratch.empty()) return store;
  if (Result<void> opened = store->open_file(); !opened) return opened.error();
  return store;
}

/// A file without a name. If the file system does not support that, a file whose name is removed at
/// once.
Result<void> TileStore::open_file() {
  const std::string& folder = options_.scratch;
  file_ = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (file_ >= 0) return {};
  if (errno != EOPNOTSUPP && errno != EISDIR && errno != EINVAL)
    return scratch_error(folder, errno);
  std::string name = folder + "/.pentimento-scratch-XXXXXX";
  file_ = mkostemp(name.data(), O_CLOEXEC);
  if (file_ < 0) return scratch_error(folder, errno);
  unlink(name.c_str());
  return {};
}

/// Reserves space on the disk, so that writing to the mapping cannot end in SIGBUS.
Result<void> TileStore::reserve(std::int64_t offset, std::size_t bytes) const {
  int problem = 0;
  do {
    problem = posix_fallocate(file_, offset, static_cast<off_t>(bytes));
  } while (problem == EINTR);
  if (problem != 0) return scratch_error(options_.scratch, problem);
  return {};
}

Result<void> TileStore::add_segment() {
  const std::size_t bytes = segment_buffers_ * stride_;
  const auto out_of_memory = [&](const char* why) {
    return Error{ErrorCode::kLimit, fmt::format("no memory for the canvas beyond {} MB: {}",
                                                mapped_ * bytes / 1'000'000, why)};
  };
  if (mapped_ == segments_.size()) return out_of_memory("too many tiles");
  const auto offset = static_cast<std::int64_t>(mapped_ * bytes);
  if (file_ >= 0) {
    if (Result<void> reserved = reserve(offset, bytes); !reserved) return reserved;
  }
  void* base = mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                    file_ >= 0 ? MAP_SHARED : MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, file_,
                    file_ >= 0 ? offset : 0);
  if (base == MAP_FAILED) return out_of_memory(std::strerror(errno));
  segments_[mapped_].base = static_cast<char*>(base);
  segments_[mapped_].last_use = std::make_unique<LastUse[]>(segment_buffers_);
  ++mapped_;
  return {};
}

Result<TileStore::Buffer> TileStore::allocate() {
  const std::lock_guard<std::mutex> lock(mutex_);
  Buffer buffer = next_;
  if (!free_.empty()) {
    buffer = free_.back();
    if (file_ >= 0) {
      if (Result<void> reserved = reserve(offset_of(buffer), stride_); !reserved)
        return reserved.error();
    }
    free_.pop_back();
  } else {
    if (buffer == mapped_ * segment_buffers_) {
      if (Result<void> added = add_segment(); !added) return added.error();
    }
    ++next_;
  }
  ++used_;
  note_use(buffer);
  return buffer;
}

void TileStore::give_memory(Buffer buffer) {
  // An old system refuses, and gives pages one by one.
  if (file_ < 0) madvise(data(buffer), stride_, MADV_POPULATE_WRITE);
}

void TileStore::free(Buffer buffer) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (last_use_of(buffer).exchange(0) != 0) --held_;
  --used_;
  free_.push_back(buffer);
  if (file_ < 0) {
    madvise(data(buffer), stride_, MADV_DONTNEED);
  } else if (fallocate(file_, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, offset_of(buffer),
                       static_cast<off_t>(stride_)) != 0) {
    std::memset(data(buffer), 0, stride_);  // a file system without holes
  }
}

float* TileStore::data(Buffer buffer) const {
  return reinterpret_cast<float*>(segments_[buffer / segment_buffers_].base +
                                  buffer % segment_buffers_ * stride_);
}

void TileStore::note_use(Buffer buffer) {
  if (last_use_of(buffer).exchange(trims_, std::memory_order_relaxed) == 0) ++held_;
}

void TileStore::drop(Buffer buffer) const {
  // The kernel frees pages of the file once they are written: tell it to begin.
  sync_file_range(file_, offset_of(buffer), static_cast<off_t>(stride_), SYNC_FILE_RANGE_WRITE);
  madvise(data(buffer), stride_, MADV_DONTNEED);
}

void TileStore::trim() {
  ++trims_;
  const std::int64_t budget = options_.resident_bytes;
  if (!gives_back() || held_bytes() <= budget) return;
  std::vector<std::pair<std::uint64_t, Buffer>> held;
  for (Buffer buffer = 0; buffer < next_; ++buffer) {
    if (const std::uint64_t last_use = last_use_of(buffer); last_use != 0)
      held.emplace_back(last_use, buffer);
  }
  std::sort(held.begin(), held.end());
  for (const auto& [last_use, buffer] : held) {
    if (held_bytes() <= budget) return;
    last_use_of(buffer) = 0;
    --held_;
    drop(buffer);
  }
}

}  // namespace pentimento
