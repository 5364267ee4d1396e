#include "core/shading/albedo_row.h"

#include <gtest/gtest.h>

#include <random>

#include "core/optics/kubelka_munk.h"
#include "core/optics/paints/paint_maker.h"
#include "core/optics/paints/pigment_library.h"
#include "core/optics/spectral/band_weights.h"

namespace pentimento {
namespace {

/// One row of random paint: bare cells, layers with and without paint, thin films and thick.
struct Row {
  Row(const Model& with, int pigments, int width) : model(with), maker(model) {
    std::vector<Pigment> palette;
    const auto names = library_pigment_names();
    for (int i = 0; i < pigments; ++i)
      palette.push_back(*maker.from_library(names[static_cast<std::size_t>(47 - i)]));
    basis = make_channels(palette, maker.wavelength_nm());
    state = make_canvas_state({width, 1, 1, 1}, 3, basis.channels(), maker.bands(), 0);
    std::mt19937 random(3);
    const auto unit = [&] { return static_cast<float>(random()) / 4294967296.0f; };
    for (int x = 0; x < width; ++x) {
      for (GroundPlane& band : state.reflectance) band.set(x, 0, unit());
      state.depth_m(x, 0) = 0.003f * unit();
      for (int k = 0; k < state.layers; ++k) {
        if (random() % 3 == 0) continue;
        const float thickness = random() % 4 == 0 ? 30.0f : 0.03f;
        for (int i = 0; i < pigments; ++i) {
          const float amount = random() % 2 == 0 ? 0 : thickness * unit() * unit();
          for (int c = 0; c < basis.channels(); ++c)
            state.channel(k, c)(x, 0) += amount * basis.load(c, i);
        }
      }
    }
  }

  std::vector<float> texels(bool with_paint = true) const {
    AlbedoCells cells;
    cells.depth_m = {state.depth_m.row(0), static_cast<std::size_t>(state.geometry.width)};
    std::vector<Field<float>> dry;
    for (const GroundPlane& band : state.reflectance) dry.push_back(band.values());
    for (const Field<float>& band : dry) cells.dry.push_back(band.row(0));
    for (const Field<float>& plane : state.pigment)
      if (with_paint) cells.amount.push_back(plane.row(0));
    cells.coverage = coverage;
    std::vector<float> out(4 * cells.depth_m.size());
    albedo_row(make_albedo_optics(basis, model), cells, out);
    return out;
  }

  /// By the rows that dry into the state, whose film is another form of the same.
  std::vector<double> expected() const {
    const std::size_t bands = state.reflectance.size();
    const auto width = static_cast<std::size_t>(state.geometry.width);
    std::vector<std::vector<float>> rows(bands, std::vector<float>(width));
    std::vector<float*> pointers;
    for (auto& row : rows) pointers.push_back(row.data());
    composite_row(make_composite_optics(basis, model), state, 0, coverage, pointers);
    const bool spectral = !basis.wavelength_nm.empty();
    const Eigen::Matrix3Xd rgb =
        spectral ? Eigen::Matrix3Xd(band_rgb_weights(basis.wavelength_nm, model.viewing()))
                 : Eigen::Matrix3Xd(Eigen::Matrix3d::Identity());
    std::vector<double> out(4 * width);
    for (std::size_t x = 0; x < width; ++x) {
      for (std::size_t b = 0; b < bands; ++b) {
        const double seen = saunderson_seen(static_cast<double>(rows[b][x]),
                                            static_cast<double>(model.saunderson_k1),
                                            static_cast<double>(model.saunderson_k2));
        for (std::size_t c = 0; c < 3; ++c)
          out[4 * x + c] += rgb(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(b)) * seen;
      }
      out[4 * x + 3] = static_cast<double>(state.depth_m(static_cast<int>(x), 0));
    }
    return out;
  }

  Model model;
  PaintMaker maker;
  ChannelBasis basis;
  CanvasState state;
  std::vector<float> coverage;
};

Model spectral(int bands) {
  Model model;
  model.optics = OpticsKind::kSpectral;
  model.bands = bands;
  model.saunderson_k2 = static_cast<float>(kMeasuredK2);
  return model;
}

void expect_as_dried(const Row& row) {
  const std::vector<float> found = row.texels();
  const std::vector<double> expected = row.expected();
  // The least z is worth 2e-6 of R; a 1 - exp(-2z) near it has lost 14 bits of 24 to a factor that
  // cancels in R but for its rounding. Saunderson's correction steepens white up to 1/(1 - k2)
  // times.
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(static_cast<double>(found[i]), expected[i], 3e-5) << i;
}

TEST(AlbedoRow, IsWhatDriesIntoTheState) {
  for (const int width : {1, 2, 15, 16, 17, 40, 255, 256, 257, 600}) {
    expect_as_dried(Row(Model{}, 4, width));
    expect_as_dried(Row(spectral(kDefaultBands), 3, width));
  }
}

TEST(AlbedoRow, ByDepthAndThroughAnInterface) {
  Model model = spectral(8);
  model.optical_thickness = OpticalThickness::kDepth;
  model.saunderson_k1 = 0.03f;
  expect_as_dried(Row(model, 2, 300));
}

TEST(AlbedoRow, WherePaintCoversPartOfACell) {
  Model model = spectral(kDefaultBands);
  model.saunderson_k1 = 0.03f;
  for (const Model& optics : {Model{}, model}) {
    Row row(optics, 3, 300);
    for (int x = 0; x < 300; ++x) row.coverage.push_back(static_cast<float>(1 + x % 7) / 7);
    expect_as_dried(row);
  }
}

TEST(AlbedoRow, OfOpticalChannels) {
  const Row row(spectral(kDefaultBands), most_palette_channels(kDefaultBands) + 1, 70);
  ASSERT_EQ(row.basis.channels(), 1 + 2 * kDefaultBands);
  expect_as_dried(row);
}

TEST(AlbedoRow, WithoutPaintIsTheDryColourToTheBit) {
  const Row row(Model{}, 2, 33);
  const std::vector<float> found = row.texels(false);
  for (std::size_t x = 0; x < 33; ++x) {
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_EQ(found[4 * x + c], row.state.reflectance[c](static_cast<int>(x), 0));
  }
}

TEST(AlbedoRow, StaysBetweenBlackAndWhiteWhateverThePaint) {
  Row row(Model{}, 3, 64);
  for (const float amount : {1e-7f, 1.1e-7f, 1e-3f, 1e3f, 1e8f}) {
    for (Field<float>& plane : row.state.pigment) plane.fill(amount);
    for (const float v : row.texels()) {
      EXPECT_GE(v, 0);
      EXPECT_LE(v, 1);
    }
  }
}

}  // namespace
}  // namespace pentimento
