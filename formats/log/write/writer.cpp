#include "formats/log/write/writer.h"

#include "formats/io/output_file.h"
#include "formats/log/stream/compress.h"
#include "formats/log/write/to_json.h"

namespace pentimento::log {

namespace {

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

Result<std::unique_ptr<Writer>> Writer::create(const std::string& path, Compression compression,
                                               bool no_clobber) {
  Result<std::unique_ptr<OutputFile>> file = OutputFile::create(path, no_clobber);
  if (!file) return file.error();
  return std::unique_ptr<Writer>(std::make_unique<LogWriter>(std::move(*file), compression));
}

}  // namespace pentimento::log
