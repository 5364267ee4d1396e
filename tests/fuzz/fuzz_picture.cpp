#include "tests/fuzz/fuzz_picture.h"

#include <cmath>
#include <string>

#include "formats/image/read_image.h"
#include "formats/io/describe.h"
#include "formats/log/parse/palette_file.h"
#include "replay/log/palette.h"
#include "tests/formats/log/log_text.h"
#include "tests/fuzz/fuzz_checks.h"

namespace pentimento::test {

namespace {

/// Small, so that a picture of a few bytes costs no time.
constexpr ImageLimits kLimits = {4096, 1 << 18};

void check_planes(const Image& image) {
  PENTIMENTO_CHECK(image.name.size() == image.plane.size());
  for (const Field<float>& plane : image.plane) {
    PENTIMENTO_CHECK(plane.width() == image.width && plane.height() == image.height);
    if (image.stored_float) continue;
    for (int y = 0; y < plane.height(); ++y)
      for (int x = 0; x < plane.width(); ++x)
        PENTIMENTO_CHECK(plane(x, y) >= 0 && plane(x, y) <= 1);
  }
}

template <typename T>
void check_result(const Result<T>& result) {
  if (!result) check_problem(result.error(), kFuzzName);
}

void describe(const std::string& path, std::string_view bytes) {
  if (bytes.starts_with("\x89PNG")) check_result(describe_png(path));
  if (bytes.starts_with("\x76\x2F\x31\x01")) check_result(describe_exr(path));
}

void check_coefficients(const Eigen::VectorXd& values) {
  for (const double value : values) PENTIMENTO_CHECK(std::isfinite(value) && value >= 0);
}

void make_paints(const std::vector<log::PigmentSpec>& specs, const Model& model) {
  const Result<Palette> palette = Palette::make(specs, PaintMaker(model));
  if (!palette) return;  // a name that is not in the library
  for (const Pigment& pigment : palette->pigments()) {
    check_coefficients(pigment.K);
    check_coefficients(pigment.S);
  }
}

}  // namespace

void fuzz_picture(std::string_view bytes) {
  static const log::TemporaryFolder folder;
  const std::string path = folder.write(kFuzzName, std::string(bytes));
  describe(path, bytes);
  for (const SampleMeaning meaning : {SampleMeaning::kLight, SampleMeaning::kRaw}) {
    Result<Image> image = read_image(path, {meaning, kLimits});
    if (!image) return check_problem(image.error(), kFuzzName);
    check_planes(*image);
    to_rec709(*image);
  }
  check_result(read_rgb(path, kLimits));
  check_result(read_grey(path, kLimits));
  check_result(read_tip(path, kLimits));
}

void fuzz_palette(std::string_view bytes) {
  static const log::TemporaryFolder folder;
  const auto specs = log::read_palette_file(folder.write(kFuzzName, std::string(bytes)));
  if (!specs) return check_problem(specs.error(), kFuzzName);
  Model model;
  make_paints(*specs, model);
  model.optics = OpticsKind::kSpectral;
  make_paints(*specs, model);
}

}  // namespace pentimento::test
