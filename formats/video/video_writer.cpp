#include "formats/video/video_writer.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include "core/base/threads.h"
#include "formats/image/module_function.h"
#include "formats/io/output_file.h"
#include "formats/video/video_module.h"

namespace pentimento {

namespace {
/// The module's functions.
struct Encoder {
  image::ModuleFunction<decltype(pentimento_create_video)> open;
  image::ModuleFunction<decltype(pentimento_write_frame)> write;
  image::ModuleFunction<decltype(pentimento_finish_video)> close;
};

Result<Encoder> load_encoder() {
  const auto open = image::module_function<decltype(pentimento_create_video)>(
      image::kVideoModule, "pentimento_create_video");
  const auto write = image::module_function<decltype(pentimento_write_frame)>(
      image::kVideoModule, "pentimento_write_frame");
  const auto close = image::module_function<decltype(pentimento_finish_video)>(
      image::kVideoModule, "pentimento_finish_video");
  if (!open) return open.error();
  if (!write) return write.error();
  if (!close) return close.error();
  return Encoder{*open, *write, *close};
}

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) {
    return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  });
  return extension;
}

/// The encoder's own file. Its extension decides the format, so it cannot be the temporary file of
/// an OutputFile. The destructor removes it.
class EncodedFile {
 public:
  explicit EncodedFile(const std::string& target) {
    static std::atomic<unsigned> counter{0};
    const std::string folder = std::filesystem::path(target).parent_path().string();
    path_ = fmt::format("{}/.pentimento-{}-{}.film{}", folder.empty() ? "." : folder, ::getpid(),
                        counter++, extension_of(target));
  }
  ~EncodedFile() { ::unlink(path_.c_str()); }
  EncodedFile(const EncodedFile&) = delete;
  EncodedFile& operator=(const EncodedFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

class EncodedVideo final : public VideoFile {
 public:
  EncodedVideo(std::string path, const VideoOptions& options, const Encoder& encoder,
               std::unique_ptr<OutputFile> file)
      : path_(std::move(path)),
        options_(options),
        encoder_(encoder),
        file_(std::move(file)),
        encoded_(path_),
        rows_({ColorProfile::kSrgb, options.dither, 0, 0}, 8),
        threads_(options.threads),
        frame_(row_bytes() * static_cast<std::size_t>(options.height)) {}
  ~EncodedVideo() override { close(); }

  Result<void> open() {
    const bool avi = extension_of(path_) == ".avi";
    const std::string& place = encoded_.path();
    const PentimentoVideoTarget video = {place.c_str(),  avi ? "MJPG" : "mp4v",
                                         avi ? 1 : 0,    options_.frames_per_second,
                                         options_.width, options_.height};
    handle_ = encoder_.open.call(&video);
    if (handle_ != nullptr) return {};
    return Error{ErrorCode::kIo, path_ + ": OpenCV has no encoder for such a film"};
  }

  Result<void> write(const PictureStrip& strip) override {
    PENTIMENTO_CHECK(strip.y0 == filled_ || strip.y0 == 0);
    PENTIMENTO_CHECK(strip.y0 + strip.rows <= options_.height &&
                     strip.plane[0].width() == options_.width);
    std::atomic<bool> numbers{true};
    threads_.for_rows(strip.rows, [&](int y) {
      const RgbRow row = {strip.plane[0].row(y), strip.plane[1].row(y), strip.plane[2].row(y)};
      std::uint8_t* out = frame_.data() + row_bytes() * static_cast<std::size_t>(strip.y0 + y);
      if (!rows_.encode(row, options_.width, strip.y0 + y, out)) numbers = false;
    });
    if (!numbers)
      return Error{ErrorCode::kNonFinite, path_ + ": the picture has a value that is not a number"};
    filled_ = strip.y0 + strip.rows;
    if (filled_ < options_.height) return {};
    filled_ = 0;
    if (Result<void> added = add_frame(frame_); !added) return added;
    if (options_.frame_done) options_.frame_done(frame_);
    return {};
  }

  Result<void> add_frame(std::span<const std::uint8_t> rgb) override {
    PENTIMENTO_CHECK(rgb.size() == frame_.size());
    if (encoder_.write.call(handle_, rgb.data()) == 0) return {};
    return Error{ErrorCode::kIo, path_ + ": a frame cannot be encoded"};
  }

  Result<Published> complete() override {
    close();
    std::ifstream encoded(encoded_.path(), std::ios::binary);
    std::vector<char> bytes(std::size_t{1} << 20);
    std::uint64_t total = 0;
    while (encoded) {
      encoded.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
      file_->write(bytes.data(), static_cast<std::size_t>(encoded.gcount()));
      total += static_cast<std::uint64_t>(encoded.gcount());
    }
    // The encoder does not report a full disk. A file that is empty or cannot be read shows it.
    if (!encoded.eof() || total == 0)
      return Error{ErrorCode::kIo, path_ + ": the film could not be encoded"};
    return file_->complete();
  }

  Result<void> publish() override {
    if (const Result<Published> published = file_->publish(); !published) return published.error();
    return {};
  }

 private:
  std::size_t row_bytes() const { return 3 * static_cast<std::size_t>(options_.width); }
  void close() {
    if (handle_ != nullptr) encoder_.close.call(handle_);
    handle_ = nullptr;
  }

  std::string path_;
  VideoOptions options_;
  Encoder encoder_;
  std::unique_ptr<OutputFile> file_;
  EncodedFile encoded_;
  RowEncoder rows_;
  Threads threads_;
  std::vector<std::uint8_t> frame_;
  int filled_ = 0;  // rows of it
  void* handle_ = nullptr;
};
}  // namespace

bool is_video_name(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension == ".avi" || extension == ".mp4" || extension == ".mkv";
}

Result<std::unique_ptr<VideoFile>> create_video(const std::string& path,
                                                const VideoOptions& options) {
  PENTIMENTO_CHECK(is_video_name(path) && options.width > 0 && options.height > 0);
  if (options.width % 2 != 0 || options.height % 2 != 0) {
    return Error{ErrorCode::kUsage,
                 fmt::format("-o {}: a film's sides are even, this one has {} x {} pixels", path,
                             options.width, options.height)};
  }
  Result<Encoder> encoder = load_encoder();
  if (!encoder) return encoder.error();
  Result<std::unique_ptr<OutputFile>> file = OutputFile::create(path, options.no_clobber);
  if (!file) return file.error();
  auto video = std::make_unique<EncodedVideo>(path, options, *encoder, std::move(*file));
  if (const Result<void> opened = video->open(); !opened) return opened.error();
  return std::unique_ptr<VideoFile>(std::move(video));
}

}  // namespace pentimento
