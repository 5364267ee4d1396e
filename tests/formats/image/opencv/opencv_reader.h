#pragma once
// What passes between the tests and the module that reads pictures through OpenCV: plain C.
// OpenCV's codecs are no part of the tests' programs, each of whose starts would take 60 ms more.

#ifdef __cplusplus
extern "C" {
#endif

/// Where the module puts a picture. Samples are float: 8 and 16 bit ones as code / largest code.
struct PentimentoPicture {
  void* owner;  // handed back to the callbacks
  /// Called once, before any row. 0 = go on.
  int (*size)(void* owner, int width, int height, int channels, int bits, int is_float);
  /// Row y: width x channels samples, channels in the order of OpenCV (B G R A, or grey).
  void (*row)(void* owner, int y, const float* samples);
  /// Called on failure, with one line.
  void (*fail)(void* owner, const char* message);
};

/// 0 = done.
int pentimento_read_picture(const char* path, const struct PentimentoPicture* to);

#ifdef __cplusplus
}
#endif
