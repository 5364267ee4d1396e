#include "formats/video/video_reader.h"

#include <cmath>
#include <fstream>
#include <string_view>
#include <utility>

#include "core/optics/srgb.h"
#include "formats/image/decode.h"
#include "formats/image/module_function.h"
#include "formats/video/video_module.h"

namespace pentimento {

struct VideoReader::Module {
  image::ModuleFunction<decltype(pentimento_open_video)> open;
  image::ModuleFunction<decltype(pentimento_next_frame)> next;
  image::ModuleFunction<decltype(pentimento_close_video)> close;
};

bool is_video(const std::string& path) {
  using namespace std::string_view_literals;
  std::ifstream file(path, std::ios::binary);
  std::array<char, 12> bytes{};
  file.read(bytes.data(), bytes.size());
  const std::string_view head(bytes.data(), static_cast<std::size_t>(file.gcount()));
  if (head.size() < bytes.size()) return false;
  return (head.starts_with("RIFF"sv) && head.substr(8) == "AVI "sv) ||
         head.substr(4, 4) == "ftyp"sv || head.substr(4, 4) == "moov"sv ||
         head.starts_with("\x1A\x45\xDF\xA3"sv) || head.starts_with("OggS"sv) ||
         head.starts_with("\x00\x00\x01\xBA"sv);
}

VideoReader::VideoReader(std::string path, const Module& module)
    : path_(std::move(path)), module_(std::make_unique<const Module>(module)) {}

VideoReader::~VideoReader() {
  close();
}

void VideoReader::close() {
  if (handle_ != nullptr) module_->close.call(handle_);
  handle_ = nullptr;
}

Result<std::unique_ptr<VideoReader>> VideoReader::open(const std::string& path,
                                                       const ImageLimits& limits) {
  const auto opens = image::module_function<decltype(pentimento_open_video)>(
      image::kVideoModule, "pentimento_open_video");
  const auto next = image::module_function<decltype(pentimento_next_frame)>(
      image::kVideoModule, "pentimento_next_frame");
  const auto closes = image::module_function<decltype(pentimento_close_video)>(
      image::kVideoModule, "pentimento_close_video");
  if (!opens) return opens.error();
  if (!next) return next.error();
  if (!closes) return closes.error();
  std::unique_ptr<VideoReader> reader(new VideoReader(path, {*opens, *next, *closes}));
  if (Result<void> begun = reader->begin(limits); !begun) return begun.error();
  return reader;
}

Result<void> VideoReader::begin(const ImageLimits& limits) {
  limits_ = limits;
  close();
  next_ = 0;
  frame_.clear();
  PentimentoVideo video = {};
  handle_ = module_->open.call(path_.c_str(), &video);
  if (handle_ == nullptr)
    return Error{ErrorCode::kBadInput, path_ + ": not a video that can be read, or a broken one"};
  if (!(video.frames_per_second > 0 && std::isfinite(video.frames_per_second)))
    return Error{ErrorCode::kBadInput, path_ + ": the video does not say its frame rate"};
  if (Result<void> fits = image::check_size(path_, video.width, video.height, limits); !fits)
    return fits;
  frames_per_second_ = video.frames_per_second;
  width_ = video.width;
  height_ = video.height;
  return {};
}

Result<std::array<Field<float>, 3>> VideoReader::frame_at(double time_s) {
  // A moment at the edge of two frames belongs to the later, also where rounding says otherwise.
  const auto wanted = static_cast<std::int64_t>(std::floor(time_s * frames_per_second_ + 1e-6));
  if (wanted + 1 < next_) {
    if (Result<void> again = begin(limits_); !again) return again.error();
  }
  std::vector<std::uint8_t> read(3 * static_cast<std::size_t>(width_) *
                                 static_cast<std::size_t>(height_));
  // Every frame is decoded on the way: which one is the last is known only after it.
  while (next_ <= wanted && module_->next.call(handle_, read.data()) == 0) {
    frame_.swap(read);
    read.resize(frame_.size());
    ++next_;
  }
  if (frame_.empty())
    return Error{ErrorCode::kBadInput, path_ + ": the video has no frame that can be read"};
  std::array<Field<float>, 3> rgb;
  for (std::size_t c = 0; c < 3; ++c) {
    rgb[c] = Field<float>(width_, height_);
    for (int y = 0; y < height_; ++y) {
      const std::uint8_t* in =
          frame_.data() + 3 * static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + c;
      for (int x = 0; x < width_; ++x, in += 3)
        rgb[c](x, y) = static_cast<float>(kSrgb8ToLinear[*in]);
    }
  }
  return rgb;
}

}  // namespace pentimento
