#include "formats/image/tiff_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <tiffio.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstring>

#include "formats/io/utf8.h"

namespace pentimento::image {

/// What libtiff calls when something is wrong. 1: it prints nothing itself.
struct TiffHandlers {
  static int error(TIFF* /*file*/, void* to, const char* /*module*/, const char* format,
                   va_list values) {
    auto& said = *static_cast<TiffFile::Said*>(to);
    std::array<char, 512> text{};
    std::vsnprintf(text.data(), text.size(), format, values);
    if (said.problem.empty()) said.problem = text.data();
    return 1;
  }
  static int warning(TIFF* file, void* to, const char* module, const char* format, va_list values) {
    const bool counts = static_cast<const TiffFile::Said*>(to)->unpacking;
    return counts ? error(file, to, module, format, values) : 1;
  }
};

namespace {
struct FreeOptions {
  void operator()(TIFFOpenOptions* options) const { TIFFOpenOptionsFree(options); }
};

Error unsupported(const std::string& what) {
  return {ErrorCode::kBadInput, what + " are not supported"};
}
}  // namespace

bool TiffLayout::is_float() const {
  return format == SAMPLEFORMAT_IEEEFP;
}
bool TiffLayout::is_grey() const {
  return photometric == PHOTOMETRIC_MINISBLACK || photometric == PHOTOMETRIC_MINISWHITE ||
         photometric == PHOTOMETRIC_LOGL;
}
bool TiffLayout::is_xyz() const {
  return photometric == PHOTOMETRIC_LOGLUV;
}
bool TiffLayout::is_inverted() const {
  return photometric == PHOTOMETRIC_MINISWHITE;
}
bool TiffLayout::is_separate() const {
  return planar == PLANARCONFIG_SEPARATE && samples > 1;
}
bool TiffLayout::is_plain() const {
  const bool whole_bytes = is_float() ? bits == 32 || bits == 64 : bits == 8 || bits == 16;
  return whole_bytes && (is_grey() || is_xyz() || photometric == PHOTOMETRIC_RGB);
}

void TiffFile::CloseTiff::operator()(::tiff* file) const {
  TIFFClose(file);
}

Result<TiffFile> TiffFile::open(const std::string& path) {
  TiffFile out;
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return Error{ErrorCode::kIo, std::strerror(errno)};
  const std::unique_ptr<TIFFOpenOptions, FreeOptions> options(TIFFOpenOptionsAlloc());
  TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), kMostAtOnce);
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), TiffHandlers::error, out.said_.get());
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), TiffHandlers::warning, out.said_.get());
  // m: not mapped into memory, so that a file that shrinks meanwhile is an error and no signal.
  out.file_.reset(TIFFFdOpenExt(file, path.c_str(), "rm", options.get()));
  if (out.file_) return out;
  ::close(file);
  return out.problem("not a TIFF, or a broken one");
}

Result<TiffLayout> TiffFile::layout() const {
  TIFF* const file = file_.get();
  TiffLayout out;
  TIFFGetField(file, TIFFTAG_IMAGEWIDTH, &out.width);
  TIFFGetField(file, TIFFTAG_IMAGELENGTH, &out.height);
  if (TIFFGetField(file, TIFFTAG_PHOTOMETRIC, &out.photometric) != 1)
    return Error{ErrorCode::kBadInput, "does not say what its samples mean"};
  if (out.photometric == PHOTOMETRIC_LOGL || out.photometric == PHOTOMETRIC_LOGLUV)
    TIFFSetField(file, TIFFTAG_SGILOGDATAFMT, SGILOGDATAFMT_FLOAT);  // the next two follow it
  TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLESPERPIXEL, &out.samples);
  TIFFGetFieldDefaulted(file, TIFFTAG_BITSPERSAMPLE, &out.bits);
  TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLEFORMAT, &out.format);
  TIFFGetFieldDefaulted(file, TIFFTAG_PLANARCONFIG, &out.planar);
  TIFFGetFieldDefaulted(file, TIFFTAG_ORIENTATION, &out.orientation);
  if (out.format == SAMPLEFORMAT_INT) return unsupported("signed samples");
  const bool is_whole = out.format == SAMPLEFORMAT_UINT || out.format == SAMPLEFORMAT_VOID;
  if (!is_whole && !out.is_float()) return unsupported("complex samples");
  if (!out.is_plain() && (out.is_float() || out.bits > 16))
    return unsupported(
        fmt::format("{} samples of {} bits", out.is_float() ? "float" : "whole", out.bits));
  const int channels = out.is_grey() ? 1 : 3;  // and perhaps one of alpha
  if (out.is_plain() && out.samples != channels && out.samples != channels + 1)
    return unsupported(fmt::format("{} channels", out.samples));
  return out;
}

void TiffFile::begin_unpacking() {
  said_->unpacking = true;
}
bool TiffFile::has_problem() const {
  return !said_->problem.empty();
}
Error TiffFile::problem(const std::string& otherwise) const {
  return {ErrorCode::kBadInput, one_line(valid_utf8(has_problem() ? said_->problem : otherwise))};
}

}  // namespace pentimento::image
