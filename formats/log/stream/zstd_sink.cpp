#include <zstd.h>

#include <vector>

#include "core/base/check.h"
#include "core/base/require_memory.h"
#include "formats/log/stream/compress.h"

namespace pentimento::log {

namespace {

class ZstdSink : public ByteSink {
 public:
  explicit ZstdSink(OutputFile& file)
      : file_(file), buffer_(ZSTD_CStreamOutSize()), stream_(ZSTD_createCStream()) {
    require_memory(stream_ != nullptr);
    PENTIMENTO_CHECK(!ZSTD_isError(ZSTD_CCtx_setParameter(stream_, ZSTD_c_checksumFlag, 1)));
  }
  ~ZstdSink() override { ZSTD_freeCStream(stream_); }
  ZstdSink(const ZstdSink&) = delete;
  ZstdSink& operator=(const ZstdSink&) = delete;

  void write(std::span<const char> bytes) override { run(bytes, ZSTD_e_continue); }
  void end() override { run({}, ZSTD_e_end); }

 private:
  void run(std::span<const char> bytes, ZSTD_EndDirective directive) {
    ZSTD_inBuffer input = {bytes.data(), bytes.size(), 0};
    for (;;) {
      ZSTD_outBuffer output = {buffer_.data(), buffer_.size(), 0};
      const std::size_t left = ZSTD_compressStream2(stream_, &output, &input, directive);
      PENTIMENTO_CHECK(!ZSTD_isError(left));
      file_.write(buffer_.data(), output.pos);
      if (directive == ZSTD_e_end ? left == 0 : input.pos == input.size) return;
    }
  }

  OutputFile& file_;
  std::vector<char> buffer_;
  ZSTD_CStream* stream_;
};

}  // namespace

std::unique_ptr<ByteSink> zstd_sink(OutputFile& file) {
  return std::make_unique<ZstdSink>(file);
}

}  // namespace pentimento::log
