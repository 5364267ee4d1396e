#include <zstd.h>

#include <vector>

#include "core/base/require_memory.h"
#include "formats/log/stream/decompress.h"

namespace pentimento::log {

namespace {

class ZstdSource : public ByteSource {
 public:
  explicit ZstdSource(std::unique_ptr<RawFile> file)
      : file_(std::move(file)), buffer_(ZSTD_DStreamInSize()), stream_(ZSTD_createDStream()) {
    require_memory(stream_ != nullptr);
  }
  ~ZstdSource() override { ZSTD_freeDStream(stream_); }
  ZstdSource(const ZstdSource&) = delete;
  ZstdSource& operator=(const ZstdSource&) = delete;

  Result<std::size_t> read(std::span<char> bytes) override {
    ZSTD_outBuffer output = {bytes.data(), bytes.size(), 0};
    while (output.pos < output.size) {
      const std::size_t before = output.pos, consumed = input_.pos;
      // Called even without input: the decoder may still hold output.
      const std::size_t code = ZSTD_decompressStream(stream_, &output, &input_);
      if (ZSTD_isError(code)) return Error{ErrorCode::kBadInput, "the zstd data are damaged"};
      if (output.pos > before || input_.pos > consumed) inside_frame_ = code != 0;
      if (output.pos > before || input_.pos < input_.size) continue;
      const Result<std::size_t> count = file_->read(buffer_);
      if (!count) return count.error();
      if (*count == 0) break;
      input_ = {buffer_.data(), *count, 0};
    }
    return output.pos;
  }

  Result<void> rewind() override {
    input_ = {nullptr, 0, 0};
    inside_frame_ = true;
    ZSTD_DCtx_reset(stream_, ZSTD_reset_session_only);
    return file_->rewind();
  }

  bool cut_short() const override { return inside_frame_; }

 private:
  std::unique_ptr<RawFile> file_;
  std::vector<char> buffer_;
  ZSTD_DStream* stream_;
  ZSTD_inBuffer input_ = {nullptr, 0, 0};
  bool inside_frame_ = true;
};

}  // namespace

std::unique_ptr<ByteSource> open_zstd(std::unique_ptr<RawFile> file) {
  return std::make_unique<ZstdSource>(std::move(file));
}

}  // namespace pentimento::log
