// The module's only file: a picture through OpenCV, row by row as floats.

#include "tests/formats/image/opencv/opencv_reader.h"

#include <exception>
#include <iostream>
#include <mutex>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>
#include <streambuf>

namespace {

/// While it lives, OpenCV is not heard. It tells std::cerr and its own log what is wrong with a
/// picture; the caller says that in one line of its own. The program itself does not use std::cerr.
class MutedOpenCv {
 public:
  MutedOpenCv()
      : alone_(only_one()),
        level_(cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT)),
        heard_(std::cerr.rdbuf(&nowhere_)) {}
  ~MutedOpenCv() {
    std::cerr.rdbuf(heard_);
    cv::utils::logging::setLogLevel(level_);
  }
  MutedOpenCv(const MutedOpenCv&) = delete;
  MutedOpenCv& operator=(const MutedOpenCv&) = delete;

 private:
  struct Nowhere : std::streambuf {
    int_type overflow(int_type c) override { return traits_type::not_eof(c); }
  };
  static std::mutex& only_one() {
    static std::mutex mutex;
    return mutex;
  }
  const std::scoped_lock<std::mutex> alone_;
  const cv::utils::logging::LogLevel level_;
  Nowhere nowhere_;
  std::streambuf* const heard_;
};

cv::Mat read_quietly(const char* path) {
  const MutedOpenCv muted;
  return cv::imread(path, cv::IMREAD_UNCHANGED);
}

/// Scale from stored codes to 0..1; 0 = a depth that is not read.
double scale_of(int depth) {
  switch (depth) {
    case CV_8U:
      return 1.0 / 255;
    case CV_16U:
      return 1.0 / 65535;
    case CV_32F:
    case CV_64F:
      return 1.0;
    default:
      return 0.0;
  }
}

/// Codes become code / largest in single precision, each rounded once.
void to_floats(const cv::Mat& row, double scale, cv::Mat& out) {
  cv::Mat exact;
  row.convertTo(exact, CV_64F, scale);
  exact.convertTo(out, CV_32F);
}

int read(const char* path, const PentimentoPicture& to) {
  const cv::Mat picture = read_quietly(path);
  if (picture.empty()) {
    to.fail(to.owner, "not a picture that can be read, or a broken one");
    return 1;
  }
  const double scale = scale_of(picture.depth());
  if (scale == 0) {
    to.fail(to.owner, "signed samples are not supported");
    return 1;
  }
  const bool is_float = picture.depth() == CV_32F || picture.depth() == CV_64F;
  const int bits = static_cast<int>(picture.elemSize1()) * 8;
  if (to.size(to.owner, picture.cols, picture.rows, picture.channels(), bits, is_float) != 0)
    return 1;
  cv::Mat row;
  for (int y = 0; y < picture.rows; ++y) {
    to_floats(picture.row(y), scale, row);
    to.row(to.owner, y, row.ptr<float>());
  }
  return 0;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) int pentimento_read_picture(
    const char* path, const PentimentoPicture* to) {
  try {
    return read(path, *to);
  } catch (const std::exception& error) {
    to->fail(to->owner, error.what());
    return 1;
  }
}
