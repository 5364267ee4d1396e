#include "formats/log/stream/compress.h"

namespace pentimento::log {

namespace {
class PlainSink : public ByteSink {
 public:
  explicit PlainSink(OutputFile& file) : file_(file) {}
  void write(std::span<const char> bytes) override { file_.write(bytes.data(), bytes.size()); }
  void end() override {}

 private:
  OutputFile& file_;
};
}  // namespace

std::unique_ptr<ByteSink> open_sink(OutputFile& file, Compression compression, Effort effort) {
  switch (compression) {
    case Compression::kGzip:
      return gzip_sink(file, effort);
    case Compression::kZstd:
      return zstd_sink(file);
    case Compression::kNone:
      break;
  }
  return std::make_unique<PlainSink>(file);
}

Compression compression_of(std::string_view path) {
  if (path.ends_with(".gz")) return Compression::kGzip;
  if (path.ends_with(".zst")) return Compression::kZstd;
  return Compression::kNone;
}

}  // namespace pentimento::log
