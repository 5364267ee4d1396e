#include "core/optics/paints/paint_maker.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/optics/spectral/bands.h"
#include "core/optics/spectral/spectrum_to_rgb.h"
#include "core/optics/spectral/upsample.h"
#include "tests/core/optics/spectral/library_mixtures.h"

namespace pentimento {
namespace {

using mixtures::Eye;

const Eye& eye() {
  static const Eye eye(kDefaultBands);
  return eye;
}

TEST(PaintMaker, InRgbWithoutAnInterfaceIsWhatItWas) {
  const PaintMaker maker;
  const Pigment made = maker.from_color("a", {0.3f, 0.5f, 0.1f}, 0.6f);
  const Pigment before = pigment_from_color("a", {0.3f, 0.5f, 0.1f}, 0.6f);
  EXPECT_EQ(made.K, before.K);
  EXPECT_EQ(made.S, before.S);
  EXPECT_EQ(maker.from_library("cadmium red")->K, find_library_pigment("cadmium red")->K);
  EXPECT_EQ(maker.substrate({0.9f, 0.8f, 0.7f}), (std::vector<float>{0.9f, 0.8f, 0.7f}));
  EXPECT_FALSE(maker.from_library("unobtainium"));
}

TEST(PaintMaker, APickedColourLooksLikeItselfOverWhite) {
  for (const int bands : {kDefaultBands, kSpectrumSamples}) {
    const Eye eye(bands);
    for (int i = 0; i < 27; ++i) {
      const std::array<float, 3> rgb = {static_cast<float>(i % 3) * 0.45f + 0.03f,
                                        static_cast<float>(i / 3 % 3) * 0.45f + 0.03f,
                                        static_cast<float>(i / 9) * 0.45f + 0.03f};
      const Lab seen = eye.film(eye.maker().from_color("c", rgb), 1, 1.0);
      Spectrum wanted = upsample(
          {static_cast<double>(rgb[0]), static_cast<double>(rgb[1]), static_cast<double>(rgb[2])});
      const Lab target = lab_of(weighted(xyz_weights({}), wanted), white_xyz({}));
      // 38 bands: moved to the edge of what Kubelka-Munk can take; fewer: their own error, which
      // the strongest colours of sRGB may take past that of paints.
      EXPECT_LT(ciede2000(seen, target), bands == kSpectrumSamples ? 0.1 : 1.0) << i;
    }
  }
}

TEST(PaintMaker, ALibraryPigmentOfRgbKeepsItsColourOverWhiteAndBlack) {
  const Eye exact(kSpectrumSamples);
  for (const std::string_view name : rgb_pigment_names()) {
    const Pigment rgb = *find_library_pigment(name), bands = exact.paint(name);
    Spectrum seen{};
    std::array<double, 3> wanted{};
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const auto b = static_cast<Eigen::Index>(i);
      seen[i] = saunderson_seen(km_over(km_film({bands.K(b), bands.S(b)}, 1), 1), 0, kMeasuredK2);
    }
    for (Eigen::Index b = 0; b < 3; ++b)
      wanted[static_cast<std::size_t>(b)] = km_over(km_film({rgb.K(b), rgb.S(b)}, 1), 1);
    const auto got = weighted(rgb_weights({}), seen);
    // over_white is moved into [2/255, 1 - 1/255].
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(got[c], wanted[c], 2.1 / 255) << name;
  }
}

TEST(PaintMaker, FlatSpectraAreGreyInRgb) {
  const std::vector<double> nm = {400, 700}, K = {0.4, 0.4}, S = {0.7, 0.7};
  const Pigment grey = pigment_from_spectrum("grey", {nm, K, S});
  // R = .300530188184084 over black (worked out by hand from K .4, S .7): the inverse gives K and S
  // back.
  for (int band = 0; band < 3; ++band) {
    EXPECT_NEAR(grey.K(band), 0.4, 1e-5);  // the colours go through floats
    EXPECT_NEAR(grey.S(band), 0.7, 1e-5);
  }
}

TEST(PaintMaker, ASpectrumThatAbsorbsTheShortWavesIsYellowInRgb) {
  const std::vector<double> nm = {380, 490, 510, 750}, K = {5, 5, 0.02, 0.02}, S = {1, 1, 1, 1};
  const Pigment yellow = PaintMaker().from_spectrum("yellow", nm, K, S);
  EXPECT_GT(yellow.K(2), 10 * yellow.K(1));
  EXPECT_GT(yellow.K(2), 10 * yellow.K(0));
}

TEST(PaintMaker, ASpectrumIsLinearBetweenItsWavelengths) {
  const PaintMaker maker({450, 500, 600}, {});
  const std::vector<double> nm = {400, 500, 600}, K = {0, 2, 4}, S = {1, 1, 2};
  const Pigment p = maker.from_spectrum("p", nm, K, S);
  EXPECT_EQ(p.K, Eigen::Vector3d(1, 2, 4));
  EXPECT_EQ(p.S, Eigen::Vector3d(1, 1, 2));
}

TEST(PaintMaker, MeasuredPaintsAreThereByName) {
  EXPECT_EQ(measured_paints().size(), 19u);
  const Pigment p = eye().paint("golden_cobalt-blue");
  const SpectralPaint* measured = find_measured_paint("Golden Cobalt Blue");
  ASSERT_NE(measured, nullptr);
  EXPECT_EQ(p.K.size(), kDefaultBands);
  // First value of the source's table.
  EXPECT_DOUBLE_EQ(find_measured_paint("golden bone black")->K[0],
                   kMeasuredScale * 0.317811397650624);
  const Pigment rgb = *PaintMaker().from_library("Golden Cobalt Blue");
  EXPECT_GT(rgb.K(0), 5 * rgb.K(2));  // absorbs red, not blue
}

/// What a film of thickness 1 of a measured paint looks like over a ground, through an interface
/// with `k2`: the CIE's observer in daylight, linear sRGB.
std::array<double, 3> look_of(const SpectralPaint& paint, double ground, double k2) {
  Spectrum seen{};
  for (std::size_t i = 0; i < seen.size(); ++i)
    seen[i] = saunderson_seen(km_over(km_film({paint.K[i], paint.S[i]}, 1), ground), 0, k2);
  return weighted(rgb_weights({}), seen);
}

TEST(MeasuredPaints, InRgbLookAsTheyWereMeasuredThroughTheirInterface) {
  Model glossy;
  glossy.saunderson_k2 = 0.5f;
  for (const SpectralPaint& paint : measured_paints()) {
    // A model without an interface has the paint as it was seen; one with an interface sees through
    // its own.
    const Pigment plain = *PaintMaker().from_library(paint.name);
    const Pigment inside = *PaintMaker(glossy).from_library(paint.name);
    for (const double ground : {0.0, 1.0}) {
      const auto seen = look_of(paint, ground, kMeasuredK2), bare = look_of(paint, ground, 0);
      for (std::size_t c = 0; c < 3; ++c) {
        const auto i = static_cast<Eigen::Index>(c);
        const auto reflects = [&](const Pigment& p) {
          return km_over(km_film({p.K(i), p.S(i)}, 1), ground);
        };
        // The fit of the observer in place of its table: 0.07 in the red of cadmium orange and
        // red, whose colours lie beyond sRGB. The interface takes up to 0.3 away.
        EXPECT_NEAR(reflects(plain), std::clamp(seen[c], 0.0, 1.0), 0.08) << paint.name << c;
        EXPECT_NEAR(reflects(inside), std::clamp(bare[c], 0.0, 1.0), 0.08) << paint.name << c;
      }
    }
  }
}

/// More white never darkens, never by a jump; the ends are the paint and the white.
TEST(MeasuredPaints, TintLaddersRiseToWhite) {
  const Pigment white = eye().paint("golden titanium white");
  for (const std::string& name : mixtures::measured_names()) {
    if (name == "Golden Titanium White" || name == "Golden Bismuth Vanadate Yellow") continue;
    const Pigment paint = eye().paint(name);
    double before = eye().opaque(white, paint, 0).L;
    for (int i = 1; i <= 20; ++i) {
      const double L = eye().opaque(white, paint, i / 20.0).L;
      EXPECT_GT(L, before) << name << i;
      before = L;
    }
    EXPECT_GT(before, 98) << name;
  }
}

// The cool yellows; diarylide, an orange one, makes olives.
constexpr const char* kYellows[] = {"golden hansa yellow opaque", "golden bismuth vanadate yellow"};
constexpr const char* kBlues[] = {"golden cobalt blue", "golden cerulean blue chromium",
                                  "golden phthalo blue red shade",
                                  "golden phthalo blue green shade"};

/// The mixture of two paints that is as light as halfway between them: both count alike in it,
/// however strong a paint is.
Lab balanced(const Pigment& light, const Pigment& dark) {
  const double halfway = (eye().opaque(light, dark, 1).L + eye().opaque(light, dark, 0).L) / 2;
  double low = 0, high = 1;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    (eye().opaque(light, dark, middle).L < halfway ? low : high) = middle;
  }
  return eye().opaque(light, dark, low);
}

struct HueRange {
  double least = 360, most = 0;
};
HueRange measured_greens() {
  HueRange range;
  for (const char* yellow : kYellows) {
    for (const char* blue : kBlues) {
      const Lab mixed = balanced(eye().paint(yellow), eye().paint(blue));
      range.least = std::min(range.least, hue_deg(mixed));
      range.most = std::max(range.most, hue_deg(mixed));
    }
  }
  return range;
}

TEST(MeasuredPaints, YellowAndBlueMixToGreen) {
  const HueRange greens = measured_greens();
  // CIELAB's yellow lies at 90, a leaf at about 120, its green at 180.
  EXPECT_GT(greens.least, 110);
  EXPECT_LT(greens.most, 180);
}

TEST(PickedColours, YellowAndBlueMixToTheGreensOfMeasuredPaints) {
  using Rgb = std::array<float, 3>;
  const HueRange greens = measured_greens();
  for (const Rgb& y : {Rgb{0.9f, 0.75f, 0.01f}, Rgb{0.95f, 0.85f, 0.02f}}) {
    for (const Rgb& b : {Rgb{0.01f, 0.06f, 0.5f}, Rgb{0.01f, 0.1f, 0.45f}}) {
      const Lab mixed =
          balanced(eye().maker().from_color("y", y), eye().maker().from_color("b", b));
      EXPECT_GT(hue_deg(mixed), greens.least);
      EXPECT_LT(hue_deg(mixed), greens.most);
      EXPECT_GT(chroma(mixed), 10);
    }
  }
}

TEST(PickedColours, InThreeBandsAYellowAndABlueMixToABrown) {
  const Pigment yellow = pigment_from_color("y", {0.97345f, 0.65141f, 0.002f});
  const Pigment blue = pigment_from_color("b", {0.002f, 0.0152f, 0.2346f});
  std::array<double, 3> rgb{};
  for (Eigen::Index i = 0; i < 3; ++i)
    rgb[static_cast<std::size_t>(i)] =
        km_opaque({(yellow.K(i) + blue.K(i)) / 2, (yellow.S(i) + blue.S(i)) / 2});
  EXPECT_GT(rgb[0], rgb[1]);  // more red than green in it
}

TEST(Glazes, DarkenAndSaturateWhatIsUnder) {
  const Pigment ground = eye().maker().from_color("skin", {0.8f, 0.6f, 0.45f});
  const Lab bare = eye().film(ground, 20, 1.0);
  for (const char* name : {"golden quinacridone magenta", "golden quinacridone red",
                           "golden phthalo green yellow shade", "golden diarylide yellow"}) {
    const Lab glazed = eye().film(eye().paint(name), 0.05, ground);
    EXPECT_LT(glazed.L, bare.L) << name;
  }
  for (const char* name :
       {"golden quinacridone magenta", "golden quinacridone red", "golden diarylide yellow"}) {
    EXPECT_GT(chroma(eye().film(eye().paint(name), 0.05, ground)), chroma(bare)) << name;
  }
}

TEST(Films, ThinnedLetTheGroundThrough) {
  for (const std::string& name : mixtures::measured_names()) {
    const Pigment paint = eye().paint(name);
    double before = 0;
    for (const double x : {3.0, 1.0, 0.3, 0.1, 0.03, 0.01}) {
      // How far apart a white and a black look under it: the more the thinner.
      const double contrast = eye().film(paint, x, 1.0).L - eye().film(paint, x, 0.0).L;
      EXPECT_GT(contrast, before) << name << x;
      before = contrast;
    }
    EXPECT_GT(before, 50) << name;  // of 100 without paint: the strongest, dioxazine, leaves 54
  }
}

TEST(Interface, GroundAndItsLookAreInverse) {
  Model model = mixtures::spectral_model(kSpectrumSamples);
  model.saunderson_k1 = 0.03f;
  const PaintMaker maker(model);
  const std::vector<float> inside = maker.substrate({0.6f, 0.5f, 0.3f});
  Spectrum seen{};
  for (std::size_t i = 0; i < seen.size(); ++i)
    seen[i] = saunderson_seen(static_cast<double>(inside[i]), static_cast<double>(0.03f),
                              static_cast<double>(model.saunderson_k2));
  const auto rgb = weighted(rgb_weights({}), seen);
  const double wanted[] = {0.6, 0.5, 0.3};
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(rgb[c], wanted[c], 1e-6);  // floats
}

TEST(Interface, APictureHasTheGroundsOfItsColours) {
  const PaintMaker maker(mixtures::spectral_model(kDefaultBands));
  std::array<Field<float>, 3> rgb;
  for (Field<float>& plane : rgb) plane = Field<float>(2, 1);
  const std::array<float, 3> color = {0.6f, 0.5f, 0.3f};
  for (std::size_t c = 0; c < 3; ++c) {
    rgb[c](0, 0) = color[c];
    rgb[c](1, 0) = 1;
  }
  const std::vector<Field<float>> planes = maker.substrate(rgb);
  ASSERT_EQ(planes.size(), static_cast<std::size_t>(kDefaultBands));
  const std::vector<float> exact = maker.substrate(color);
  for (std::size_t b = 0; b < planes.size(); ++b) {
    // Sums of corners are less smooth than the smoothest spectrum of the colour.
    EXPECT_NEAR(planes[b](0, 0), exact[b], 0.12);
    EXPECT_GT(planes[b](1, 0), 0.98f);
  }
}

TEST(PaintMaker, APictureBrighterThanWhiteIsWhite) {
  const PaintMaker& maker = eye().maker();
  std::array<Field<float>, 3> rgb;
  for (Field<float>& plane : rgb) {
    plane = Field<float>(2, 1, 1.0f);
    plane(1, 0) = 4;
  }
  for (const Field<float>& plane : maker.substrate(rgb)) EXPECT_EQ(plane(1, 0), plane(0, 0));
}

}  // namespace
}  // namespace pentimento
