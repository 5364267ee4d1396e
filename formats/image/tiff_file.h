#pragma once
// A TIFF that is open for reading: libtiff's handle, what it said, and how the samples are stored.
// For the .cpp files of this folder only.

#include <cstdint>
#include <memory>
#include <string>

#include "core/base/result.h"

struct tiff;  // libtiff's TIFF

namespace pentimento::image {

/// What the first directory says of the samples, in TIFF's numbers.
struct TiffLayout {
  std::uint32_t width = 0, height = 0;
  std::uint16_t samples = 1, bits = 1, format = 1, photometric = 0, planar = 1, orientation = 1;

  bool is_float() const;
  bool is_grey() const;
  /// Floats of CIE XYZ, where Y = 1 is white.
  bool is_xyz() const;
  /// White is 0.
  bool is_inverted() const;
  /// Each sample in a plane of its own?
  bool is_separate() const;
  /// Whether the file holds the values of our planes, each as whole bytes; libtiff makes 8 bits of
  /// red, green and blue of everything else.
  bool is_plain() const;
};

class TiffFile {
 public:
  /// What is taken at once at most, bytes: a picture of the most pixels as four doubles each.
  static constexpr std::int64_t kMostAtOnce = std::int64_t{1} << 32;

  /// Errors (without the file's name): kIo, kBadInput.
  static Result<TiffFile> open(const std::string& path);

  ::tiff* handle() const { return file_.get(); }
  /// Errors: kBadInput for samples that are not supported. Logarithms of light are unpacked as
  /// floats.
  Result<TiffLayout> layout() const;
  /// From here on warnings count, too. Before, libtiff warns of tags that it does not know, which
  /// is no damage; while it unpacks samples it warns of what it then makes up, which is.
  void begin_unpacking();
  /// Has libtiff said something that counts?
  bool has_problem() const;
  /// The first that it said, or `otherwise`; kBadInput.
  Error problem(const std::string& otherwise) const;

 private:
  struct Said {
    bool unpacking = false;
    std::string problem;
  };
  struct CloseTiff {
    void operator()(::tiff* file) const;
  };
  friend struct TiffHandlers;

  std::unique_ptr<Said> said_ = std::make_unique<Said>();  // libtiff keeps its address
  std::unique_ptr<::tiff, CloseTiff> file_;
};

}  // namespace pentimento::image
