#pragma once
// What passes between the programme and the module that reads pictures through OpenCV: plain C, so
// that the module can be built and loaded on its own. The module takes 60 ms to load; only who
// reads a TIFF or draws text pays that.

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

/// A line of text to be drawn into a mask, 0 to 255 = how much of a pixel it covers.
struct PentimentoText {
  const char* text;  // ASCII
  double scale;      // 1: capitals are 21 pixels high
  int thickness;     // of its lines, pixels
};

/// How wide and how high above its base line it is, pixels. 0 = done.
int pentimento_measure_text(const struct PentimentoText* text, int* width, int* height);

/// Draws with the base line's left end at (x, y). What falls outside is cut. 0 = done.
int pentimento_draw_text(const struct PentimentoText* text, int x, int y, unsigned char* mask,
                         int mask_width, int mask_height);

#ifdef __cplusplus
}
#endif
