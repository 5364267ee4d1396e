#pragma once
// What passes between the programme and the module that writes videos and reads videos through
// OpenCV: plain C, as in formats/image/text_module.h. Frames are rows of R, G, B bytes without
// padding.

#ifdef __cplusplus
extern "C" {
#endif

struct PentimentoVideoTarget {
  const char* path;
  const char* codec;  // four characters
  int built_in;       // 1: OpenCV's own writer of Motion JPEG in AVI; 0: FFmpeg
  double frames_per_second;
  int width, height;  // even
};

/// Null: it cannot be written.
void* pentimento_create_video(const struct PentimentoVideoTarget* video);
/// 0 = done.
int pentimento_write_frame(void* video, const unsigned char* rgb);
/// Ends the file.
void pentimento_finish_video(void* video);

struct PentimentoVideo {
  double frames_per_second;  // 0: it does not say
  int width, height;
};

/// Null: not a video that can be read.
void* pentimento_open_video(const char* path, struct PentimentoVideo* video);
/// The next frame. `rgb` null: it is passed over. 0 = done, 1 = there is none.
int pentimento_next_frame(void* video, unsigned char* rgb);
void pentimento_close_video(void* video);

#ifdef __cplusplus
}
#endif
