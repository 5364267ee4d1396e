#pragma once
// Writes videos: Motion JPEG in .avi, MPEG-4 in .mp4 and .mkv. A frame is a whole picture in
// strips, and its light becomes sRGB as in a PNG of 8 bits. The encoder writes a temporary file
// beside the target; the whole file then gets the name.

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "core/base/result.h"
#include "formats/color/row_encoder.h"
#include "formats/io/picture_file.h"

namespace pentimento {

struct VideoOptions {
  int width = 0, height = 0;
  double frames_per_second = 25;
  bool no_clobber = false;
  bool dither = false;
  int threads = 1;
  /// Told of every frame that was encoded: red, green and blue of 8 bits, row by row.
  std::function<void(std::span<const std::uint8_t> rgb)> frame_done = {};
};

class VideoFile : public PictureFile {
 public:
  /// Encodes a frame that frame_done() was told of when such a video was made before. Errors: kIo.
  virtual Result<void> add_frame(std::span<const std::uint8_t> rgb) = 0;
};

/// Whether a name has the extension .avi, .mp4 or .mkv, in upper or lower case.
bool is_video_name(const std::string& path);

/// Takes frame after frame: a strip that begins at row 0 begins the next frame. complete() ends the
/// video. Errors: kUsage (an odd side), kIo (no encoder, not writable), kNonFinite from write().
Result<std::unique_ptr<VideoFile>> create_video(const std::string& path,
                                                const VideoOptions& options);

}  // namespace pentimento
