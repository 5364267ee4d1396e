#include <gtest/gtest.h>

#include <random>

#include "core/optics/composite.h"
#include "core/shading/shader.h"
#include "core/simulation/drying.h"
#include "tests/core/optics/spectral/library_mixtures.h"
#include "tests/reference/whole_picture.h"

namespace pentimento {
namespace {

using reference::WholePicture;

/// A canvas of random paint, two layers of it, in the bands of a model.
struct Canvas {
  Canvas(const Model& with, int pigments) : model(with), maker(model) {
    const auto names = library_pigment_names();
    std::vector<Pigment> palette;
    for (int i = 0; i < pigments; ++i)
      palette.push_back(*maker.from_library(names[static_cast<std::size_t>(47 - i)]));
    basis = make_channels(palette, maker.wavelength_nm());
    state = make_canvas_state({12, 9, 0.12, 0.09}, 2, basis.channels(), maker.bands(), 0);
    std::mt19937 random(1);
    const auto unit = [&] { return static_cast<float>(random()) / 4294967296.0f; };
    for (GroundPlane& plane : state.reflectance) plane.fill(0.7f);
    state.depth_m.fill(0.001f);
    for (int layer = 0; layer < 2; ++layer) {
      for (int y = 0; y < 9; ++y) {
        for (int x = 0; x < 12; ++x) {
          const auto i = static_cast<Eigen::Index>(random() % static_cast<unsigned>(pigments));
          const float amount = 0.05f * unit();
          for (int c = 0; c < basis.channels(); ++c)
            state.channel(layer, c)(x, y) = amount * basis.load(c, i);
        }
      }
    }
  }

  Result<WholePicture> shade(const std::vector<std::string>& aovs = {"albedo"}) const {
    static const auto shader = Shader::open(GlBackend::kAuto, 0);
    ShadeRequest request;
    request.width = 12;
    request.height = 9;
    request.aovs = aovs;
    WholePicture picture;
    const auto done =
        (*shader)->shade(StateSource(state), basis, model, lighting, request, {&picture});
    if (!done) return done.error();
    return picture;
  }

  Model model;
  PaintMaker maker;
  ChannelBasis basis;
  CanvasState state;
  Lighting lighting;
};

/// What the drying of a row and the weights of the bands say.
std::array<double, 3> expected_albedo(const Canvas& canvas, int x, int y) {
  const int bands = canvas.maker.bands();
  std::vector<std::vector<float>> row(static_cast<std::size_t>(bands), std::vector<float>(12));
  std::vector<float*> out;
  for (auto& r : row) out.push_back(r.data());
  composite_row(make_composite_optics(canvas.basis, canvas.model), canvas.state, y, {}, out);
  const Eigen::Matrix3Xd weights =
      band_rgb_weights(canvas.basis.wavelength_nm, canvas.model.viewing());
  std::array<double, 3> rgb{};
  for (int b = 0; b < bands; ++b) {
    const double seen = saunderson_seen(
        static_cast<double>(row[static_cast<std::size_t>(b)][static_cast<std::size_t>(x)]),
        static_cast<double>(canvas.model.saunderson_k1),
        static_cast<double>(canvas.model.saunderson_k2));
    for (std::size_t c = 0; c < 3; ++c) rgb[c] += weights(static_cast<Eigen::Index>(c), b) * seen;
  }
  return rgb;
}

void expect_as_the_plain_sum(const Canvas& canvas) {
  const auto picture = canvas.shade();
  ASSERT_TRUE(picture) << picture.error().message;
  for (int y = 0; y < 9; ++y) {
    for (int x = 0; x < 12; ++x) {
      const auto rgb = expected_albedo(canvas, x, y);
      for (std::size_t c = 0; c < 3; ++c) {
        // Floats and the shader's own exp, over a score of bands.
        EXPECT_NEAR(picture->at(std::string("albedo.") + "RGB"[c], x, y), rgb[c], 5e-5);
      }
    }
  }
}

TEST(SpectralShading, IsTheSumOfTheBandsThroughTheInterface) {
  for (const int bands : {kDefaultBands, kSpectrumSamples})
    expect_as_the_plain_sum(Canvas(mixtures::spectral_model(bands), 4));
}

TEST(SpectralShading, ByDepthAndInAnotherLight) {
  Model model = mixtures::spectral_model(kDefaultBands);
  model.optical_thickness = OpticalThickness::kDepth;
  model.illuminant = Illuminant::kA;
  model.observer = Observer::kCie1964;
  model.saunderson_k1 = 0.03f;
  expect_as_the_plain_sum(Canvas(model, 3));
}

TEST(SpectralShading, TakesMorePigmentsThanEightAndOpticalChannels) {
  const int most = most_palette_channels(kDefaultBands);
  const Canvas many(mixtures::spectral_model(kDefaultBands), 12);
  EXPECT_EQ(many.basis.channels(), 12);
  expect_as_the_plain_sum(many);
  const Canvas optical(mixtures::spectral_model(kDefaultBands), most + 1);
  EXPECT_EQ(optical.basis.channels(), 1 + 2 * kDefaultBands);
  expect_as_the_plain_sum(optical);
}

TEST(SpectralShading, WhatOpenGlDoesNotHoldIsAnErrorThatNamesIt) {
  Canvas canvas(mixtures::spectral_model(kDefaultBands), 40);  // 1 + 2 bands channels as AOVs
  const auto picture = canvas.shade({"pigment", "albedo", "normal"});
  ASSERT_FALSE(picture);
  EXPECT_EQ(picture.error().code, ErrorCode::kLimit);
  EXPECT_NE(picture.error().message.find("AOVs of"), std::string::npos) << picture.error().message;
}

TEST(SpectralShading, BarePaperLooksAsAskedInEveryLight) {
  Canvas canvas(mixtures::spectral_model(kDefaultBands), 1);
  for (Field<float>& plane : canvas.state.pigment) plane.fill(0);
  const std::vector<float> paper = canvas.maker.substrate({0.5f, 0.5f, 0.5f});
  for (std::size_t b = 0; b < paper.size(); ++b) canvas.state.reflectance[b].fill(paper[b]);
  for (const Illuminant light : {Illuminant::kD65, Illuminant::kA, Illuminant::kF11}) {
    canvas.model.illuminant = light;
    const auto picture = canvas.shade();
    ASSERT_TRUE(picture);
    // A grey is grey in every light its eye is adapted to.
    for (const char c : {'R', 'G', 'B'})
      EXPECT_NEAR(picture->at(std::string("albedo.") + c, 4, 4), 0.5, 1e-3);
  }
}

TEST(SpectralDrying, LeavesWhatTheWetPaintLookedLike) {
  Canvas canvas(mixtures::spectral_model(kDefaultBands), 4);
  // A film that ends in the third column, whose cells it covers in part.
  for (int y = 0; y < canvas.state.geometry.height; ++y) {
    const auto thin = [&](Field<float>& plane) {
      plane(0, y) = plane(1, y) = 0;
      plane(2, y) *= 0.1f;
    };
    thin(canvas.state.depth_m);
    for (Field<float>& plane : canvas.state.pigment) thin(plane);
  }
  const auto wet = canvas.shade();
  PaintFlow dried = wet_paint(canvas.state);
  dry_canvas(canvas.state, canvas.basis, canvas.model, EdgeCells::kPartlyCovered, Threads(1),
             dried);
  const auto dry = canvas.shade();
  ASSERT_TRUE(wet && dry);
  for (const auto& [name, plane] : wet->planes) {
    if (!name.starts_with("albedo")) continue;
    for (std::size_t i = 0; i < plane.size(); ++i)
      EXPECT_NEAR(plane[i], dry->planes.at(name)[i], 5e-5) << name;  // floats, twice
  }
}

}  // namespace
}  // namespace pentimento
