#pragma once
// Reads videos of any kind that OpenCV reads, as linear light: the picture of the front camera at a
// moment. Frames are read in order; to go back, the reader begins anew.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/field.h"
#include "core/base/result.h"
#include "formats/image/read_image.h"

namespace pentimento {

/// Whether a file is a video by its first bytes: AVI, MP4 and QuickTime, Matroska and WebM, Ogg,
/// MPEG. False for a file that cannot be read.
bool is_video(const std::string& path);

class VideoReader {
 public:
  /// Errors: kBadInput (not a video that can be read, no frame rate), kLimit.
  static Result<std::unique_ptr<VideoReader>> open(const std::string& path,
                                                   const ImageLimits& limits = {});
  ~VideoReader();
  VideoReader(const VideoReader&) = delete;
  VideoReader& operator=(const VideoReader&) = delete;

  /// Red, green and blue of the frame that is shown `time_s` >= 0 after the first frame; after the
  /// end, the last frame. A frame lasts 1 / frame rate. Errors: kBadInput, the video has no frame.
  Result<std::array<Field<float>, 3>> frame_at(double time_s);

 private:
  struct Module;
  VideoReader(std::string path, const Module& module);
  Result<void> begin(const ImageLimits& limits);
  void close();

  std::string path_;
  std::unique_ptr<const Module> module_;
  ImageLimits limits_;
  void* handle_ = nullptr;
  double frames_per_second_ = 0;
  int width_ = 0, height_ = 0;
  std::int64_t next_ = 0;  // frame
  std::vector<std::uint8_t> frame_;
};

}  // namespace pentimento
