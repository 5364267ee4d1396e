#include "formats/log/stream/byte_source.h"

#include <array>
#include <string_view>

#include "formats/log/stream/decompress.h"

namespace pentimento::log {

namespace {

class PlainSource : public ByteSource {
 public:
  explicit PlainSource(std::unique_ptr<RawFile> file) : file_(std::move(file)) {}
  Result<std::size_t> read(std::span<char> bytes) override { return file_->read(bytes); }
  Result<void> rewind() override { return file_->rewind(); }

 private:
  std::unique_ptr<RawFile> file_;
};

constexpr std::string_view kGzipMagic = "\x1f\x8b";
constexpr std::string_view kZstdMagic = "\x28\xb5\x2f\xfd";

}  // namespace

Result<std::unique_ptr<ByteSource>> ByteSource::open(const std::string& path,
                                                     const ReaderOptions& options) {
  Result<std::unique_ptr<RawFile>> file = RawFile::open(path, options);
  if (!file) return file.error();
  std::array<char, 4> start{};
  const Result<std::size_t> count = (*file)->read(start);
  if (!count) return count.error();
  const Result<void> rewound = (*file)->rewind();
  if (!rewound) return rewound.error();
  const std::string_view magic(start.data(), *count);
  std::unique_ptr<ByteSource> source;
  if (magic.starts_with(kGzipMagic)) {
    source = open_gzip(std::move(*file));
  } else if (magic == kZstdMagic) {
    source = open_zstd(std::move(*file));
  } else {
    source = std::make_unique<PlainSource>(std::move(*file));
  }
  return source;
}

}  // namespace pentimento::log
