#include "formats/log/write/writer.h"

#include "formats/io/output_file.h"
#include "formats/log/stream/compress.h"
#include "formats/log/write/to_json.h"

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

std::unique_ptr<ByteSink> open_sink(OutputFile& file, Compression compression) {
  switch (compression) {
    case Compression::kGzip:
      return gzip_sink(file);
    case Compression::kZstd:
      return zstd_sink(file);
    case Compression::kNone:
      break;
  }
  return std::make_unique<PlainSink>(file);
}

class LogWriter : public Writer {
 public:
  LogWriter(std::unique_ptr<OutputFile> file, Compression compression)
      : file_(std::move(file)), sink_(open_sink(*file_, compression)) {}

  void write(const Header& header) override { write_line(header_json(header)); }
  void write(const Event& event) override { write_line(event_json(event)); }
  Result<Published> finish() override {
    sink_->end();
    return file_->publish();
  }

 private:
  void write_line(std::string line) {
    line += '\n';
    sink_->write(line);
  }

  std::unique_ptr<OutputFile> file_;
  std::unique_ptr<ByteSink> sink_;
};

}  // namespace

Compression compression_of(std::string_view path) {
  if (path.ends_with(".gz")) return Compression::kGzip;
  if (path.ends_with(".zst")) return Compression::kZstd;
  return Compression::kNone;
}

Result<std::unique_ptr<Writer>> Writer::create(const std::string& path, Compression compression,
                                               bool no_clobber) {
  Result<std::unique_ptr<OutputFile>> file = OutputFile::create(path, no_clobber);
  if (!file) return file.error();
  return std::unique_ptr<Writer>(std::make_unique<LogWriter>(std::move(*file), compression));
}

}  // namespace pentimento::log
