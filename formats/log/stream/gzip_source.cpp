#include <zlib.h>

#include <vector>

#include "core/base/check.h"
#include "core/base/require_memory.h"
#include "formats/log/stream/decompress.h"
#include "formats/log/stream/gzip_window.h"

namespace pentimento::log {

namespace {

class GzipSource : public ByteSource {
 public:
  explicit GzipSource(std::unique_ptr<RawFile> file) : file_(std::move(file)), input_(1 << 17) {
    require_memory(inflateInit2(&stream_, kGzipWindow) == Z_OK);
  }
  ~GzipSource() override { inflateEnd(&stream_); }
  GzipSource(const GzipSource&) = delete;
  GzipSource& operator=(const GzipSource&) = delete;

  Result<std::size_t> read(std::span<char> bytes) override {
    stream_.next_out = reinterpret_cast<Bytef*>(bytes.data());
    stream_.avail_out = static_cast<uInt>(bytes.size());
    while (stream_.avail_out > 0) {
      const Result<bool> more = refill();
      if (!more) return more.error();
      if (!*more) break;
      const int code = inflate(&stream_, Z_NO_FLUSH);
      inside_member_ = code != Z_STREAM_END;
      if (code != Z_OK && code != Z_STREAM_END && code != Z_BUF_ERROR) {
        return Error{ErrorCode::kBadInput, "the gzip data are damaged"};
      }
    }
    return bytes.size() - stream_.avail_out;
  }

  Result<void> rewind() override {
    stream_.avail_in = 0;
    inside_member_ = true;
    PENTIMENTO_CHECK(inflateReset(&stream_) == Z_OK);
    return file_->rewind();
  }

  bool cut_short() const override { return inside_member_; }

 private:
  /// Makes sure that there is input and a member to read; false at the end of the file.
  Result<bool> refill() {
    if (stream_.avail_in == 0) {
      const Result<std::size_t> count = file_->read(input_);
      if (!count) return count.error();
      if (*count == 0) return false;
      stream_.next_in = reinterpret_cast<Bytef*>(input_.data());
      stream_.avail_in = static_cast<uInt>(*count);
    }
    if (!inside_member_) PENTIMENTO_CHECK(inflateReset(&stream_) == Z_OK);
    return true;
  }

  std::unique_ptr<RawFile> file_;
  std::vector<char> input_;
  z_stream stream_{};
  bool inside_member_ = true;
};

}  // namespace

std::unique_ptr<ByteSource> open_gzip(std::unique_ptr<RawFile> file) {
  return std::make_unique<GzipSource>(std::move(file));
}

}  // namespace pentimento::log
