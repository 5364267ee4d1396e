// Lines of text for legends, in OpenCV's plain stroke font.

#include <exception>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "formats/image/text_module.h"

namespace {
constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
}

extern "C" __attribute__((visibility("default"))) int pentimento_measure_text(
    const PentimentoText* text, int* width, int* height) {
  try {
    int below = 0;
    const cv::Size size = cv::getTextSize(text->text, kFont, text->scale, text->thickness, &below);
    *width = size.width;
    *height = size.height;
    return 0;
  } catch (const std::exception&) {
    return 1;
  }
}

extern "C" __attribute__((visibility("default"))) int pentimento_draw_text(
    const PentimentoText* text, int x, int y, unsigned char* mask, int mask_width,
    int mask_height) {
  try {
    cv::Mat plane(mask_height, mask_width, CV_8UC1, mask);
    cv::putText(plane, text->text, cv::Point(x, y), kFont, text->scale, cv::Scalar(255),
                text->thickness, cv::LINE_AA);
    return 0;
  } catch (const std::exception&) {
    return 1;
  }
}
