#pragma once
// What passes between the programme and the module that draws text through OpenCV: plain C, so that
// the module can be built and loaded on its own. The module takes 60 ms to load; only who draws
// text pays that.

#ifdef __cplusplus
extern "C" {
#endif

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
