// Writes videos through OpenCV.

#include <cstddef>
#include <exception>
#include <memory>
#include <opencv2/core.hpp>

// OpenCV's list of properties adds up numbers of different enumerations.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-enum-enum-conversion"
#include <opencv2/videoio.hpp>
#pragma GCC diagnostic pop

#include "formats/video/video_module.h"

namespace {
struct VideoEncoder {
  cv::VideoWriter writer;
  cv::Mat frame;  // B G R
};
}  // namespace

#define PENTIMENTO_EXPORT extern "C" __attribute__((visibility("default")))

PENTIMENTO_EXPORT void* pentimento_create_video(const PentimentoVideoTarget* video) {
  try {
    const char* c = video->codec;
    auto opened = std::make_unique<VideoEncoder>();
    opened->frame.create(video->height, video->width, CV_8UC3);
    const int backend = video->built_in != 0 ? cv::CAP_OPENCV_MJPEG : cv::CAP_FFMPEG;
    opened->writer.open(video->path, backend, cv::VideoWriter::fourcc(c[0], c[1], c[2], c[3]),
                        video->frames_per_second, opened->frame.size());
    if (opened->writer.isOpened()) return opened.release();
  } catch (const std::exception&) {
    // As if it could not be opened: the caller says so.
  }
  return nullptr;
}

PENTIMENTO_EXPORT int pentimento_write_frame(void* video, const unsigned char* rgb) {
  try {
    VideoEncoder& to = *static_cast<VideoEncoder*>(video);
    for (int y = 0; y < to.frame.rows; ++y) {
      unsigned char* out = to.frame.ptr(y);
      for (int x = 0; x < to.frame.cols; ++x, rgb += 3, out += 3) {
        out[0] = rgb[2];
        out[1] = rgb[1];
        out[2] = rgb[0];
      }
    }
    to.writer.write(to.frame);
    return 0;
  } catch (const std::exception&) {
    return 1;
  }
}

PENTIMENTO_EXPORT void pentimento_finish_video(void* video) {
  delete static_cast<VideoEncoder*>(video);
}
