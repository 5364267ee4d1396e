// Videos in, through OpenCV, frame by frame: jumping to a time is not exact in every container.

#include <dlfcn.h>

#include <cstdarg>
#include <exception>
#include <memory>
#include <opencv2/core.hpp>

// OpenCV's list of properties adds up numbers of different enumerations.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-enum-enum-conversion"
#include <opencv2/videoio.hpp>
#pragma GCC diagnostic pop

#include "formats/video/video_module.h"

#define PENTIMENTO_EXPORT extern "C" __attribute__((visibility("default")))

namespace {
struct VideoHandle {
  cv::VideoCapture capture;
  cv::Mat frame;  // B G R
};

/// From now on FFmpeg is not heard in this process. It prints what is wrong with a video, line
/// after line; the caller says that in one. FFmpeg comes with OpenCV, which has no function for
/// this, and its headers are not needed otherwise.
void silence_ffmpeg() {
  using Listener = void (*)(void*, int, const char*, std::va_list);
  using SetListener = void (*)(Listener);
  void* const found = dlsym(RTLD_DEFAULT, "av_log_set_callback");
  if (found == nullptr) return;
  reinterpret_cast<SetListener>(found)([](void*, int, const char*, std::va_list) {});
}
}  // namespace

PENTIMENTO_EXPORT void* pentimento_open_video(const char* path, PentimentoVideo* video) {
  try {
    silence_ffmpeg();
    auto opened = std::make_unique<VideoHandle>();
    // Only what reads files: asked for any reader, OpenCV would look among the cameras on the bus.
    if (opened->capture.open(path, cv::CAP_FFMPEG) ||
        opened->capture.open(path, cv::CAP_OPENCV_MJPEG)) {
      video->frames_per_second = opened->capture.get(cv::CAP_PROP_FPS);
      video->width = static_cast<int>(opened->capture.get(cv::CAP_PROP_FRAME_WIDTH));
      video->height = static_cast<int>(opened->capture.get(cv::CAP_PROP_FRAME_HEIGHT));
      return opened.release();
    }
  } catch (const std::exception&) {
    // As if it could not be opened: the caller says so.
  }
  return nullptr;
}

PENTIMENTO_EXPORT int pentimento_next_frame(void* video, unsigned char* rgb) {
  try {
    VideoHandle& from = *static_cast<VideoHandle*>(video);
    if (!from.capture.grab()) return 1;
    if (rgb == nullptr) return 0;
    const int width = static_cast<int>(from.capture.get(cv::CAP_PROP_FRAME_WIDTH));
    const int height = static_cast<int>(from.capture.get(cv::CAP_PROP_FRAME_HEIGHT));
    if (!from.capture.retrieve(from.frame) || from.frame.type() != CV_8UC3 ||
        from.frame.cols != width || from.frame.rows != height)
      return 1;
    for (int y = 0; y < height; ++y) {
      const unsigned char* in = from.frame.ptr(y);
      for (int x = 0; x < width; ++x, rgb += 3, in += 3) {
        rgb[0] = in[2];
        rgb[1] = in[1];
        rgb[2] = in[0];
      }
    }
    return 0;
  } catch (const std::exception&) {
    return 1;
  }
}

PENTIMENTO_EXPORT void pentimento_close_video(void* video) {
  delete static_cast<VideoHandle*>(video);
}
