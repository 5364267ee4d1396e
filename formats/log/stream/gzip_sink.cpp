// Makes the pointer to the input one to const.
#define ZLIB_CONST
#include <zlib.h>

#include <vector>

#include "core/base/check.h"
#include "core/base/require_memory.h"
#include "formats/log/stream/compress.h"
#include "formats/log/stream/gzip_window.h"

namespace pentimento::log {

namespace {

constexpr int kMemory = 8;  // zlib's default

class GzipSink : public ByteSink {
 public:
  GzipSink(OutputFile& file, Effort effort) : file_(file), buffer_(1 << 16) {
    const int level = effort == Effort::kLittle ? Z_BEST_SPEED : Z_DEFAULT_COMPRESSION;
    require_memory(deflateInit2(&stream_, level, Z_DEFLATED, kGzipWindow, kMemory,
                                Z_DEFAULT_STRATEGY) == Z_OK);
  }
  ~GzipSink() override { deflateEnd(&stream_); }
  GzipSink(const GzipSink&) = delete;
  GzipSink& operator=(const GzipSink&) = delete;

  void write(std::span<const char> bytes) override {
    stream_.next_in = reinterpret_cast<const Bytef*>(bytes.data());
    stream_.avail_in = static_cast<uInt>(bytes.size());
    run(Z_NO_FLUSH);
  }
  void end() override { run(Z_FINISH); }

 private:
  void run(int flush) {
    do {
      stream_.next_out = buffer_.data();
      stream_.avail_out = static_cast<uInt>(buffer_.size());
      PENTIMENTO_CHECK(deflate(&stream_, flush) != Z_STREAM_ERROR);
      file_.write(buffer_.data(), buffer_.size() - stream_.avail_out);
    } while (stream_.avail_out == 0);
  }

  OutputFile& file_;
  std::vector<Bytef> buffer_;
  z_stream stream_{};
};

}  // namespace

std::unique_ptr<ByteSink> gzip_sink(OutputFile& file, Effort effort) {
  return std::make_unique<GzipSink>(file, effort);
}

}  // namespace pentimento::log
