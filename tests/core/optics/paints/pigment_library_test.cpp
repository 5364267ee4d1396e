#include "core/optics/paints/pigment_library.h"

#include <gtest/gtest.h>

#include "core/optics/kubelka_munk.h"

namespace pentimento {
namespace {

TEST(PigmentLibrary, FindsNamesHoweverTheyAreWritten) {
  for (const char* name : {"Cadmium Red", "cadmium red", "CADMIUM-RED", "cadmium_red"}) {
    const Pigment* p = find_library_pigment(name);
    ASSERT_NE(p, nullptr) << name;
    EXPECT_EQ(p->name, "Cadmium Red");
  }
  EXPECT_NE(find_library_pigment("hookers green"), nullptr);
  EXPECT_EQ(find_library_pigment("cadmium"), nullptr);
  EXPECT_EQ(find_library_pigment(""), nullptr);
}

TEST(PigmentLibrary, EachListedNameIsFoundOnce) {
  for (const std::string_view name : rgb_pigment_names()) {
    const Pigment* p = find_library_pigment(name);
    ASSERT_NE(p, nullptr) << name;
    EXPECT_EQ(p->name, name);
    EXPECT_GE(p->K.minCoeff(), 0);
    EXPECT_GE(p->S.minCoeff(), 0);
  }
}

struct Seen {
  const char* name;
  double over_white[3];
};
/// From the published K and S in high precision, rounded to four digits and then to three: 5.5e-4.
TEST(PigmentLibrary, CurtisPigmentsLookAsPublishedOverWhite) {
  constexpr Seen kSeen[] = {
      {"Quinacridone Rose", {.646, .054, .324}},  {"Indian Red", {.512, .193, .095}},
      {"Cadmium Yellow", {.829, .536, .002}},     {"Hooker's Green", {.042, .297, .038}},
      {"Cerulean Blue", {.062, .546, .626}},      {"Burnt Umber", {.244, .066, .016}},
      {"Cadmium Red", {.770, .119, .039}},        {"Brilliant Orange", {.771, .200, .002}},
      {"Hansa Yellow", {.889, .688, .030}},       {"Phthalo Green", {.047, .397, .289}},
      {"French Ultramarine", {.180, .180, .887}}, {"Interference Lilac", {.861, .808, .877}},
  };
  for (const Seen& s : kSeen) {
    const Pigment* p = find_library_pigment(s.name);
    ASSERT_NE(p, nullptr) << s.name;
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(km_over(km_film({p->K(i), p->S(i)}, 1), 1), s.over_white[i], 5.51e-4) << s.name;
    }
  }
}

TEST(PigmentLibrary, YellowOverBlueIsGreenerThanBlueAndMixesAsPublished) {
  const Pigment* yellow = find_library_pigment("cadmium yellow");
  const Pigment* blue = find_library_pigment("french ultramarine");
  const double stacked[] = {.489739, .324149, .001807}, mixed[] = {.297393, .204990, .014111};
  for (int i = 0; i < 3; ++i) {
    const KmFilm top = km_film({yellow->K(i), yellow->S(i)}, 1);
    const KmFilm below = km_film({blue->K(i), blue->S(i)}, 1);
    EXPECT_NEAR(km_over(top, km_over(below, .9)), stacked[i], 5.01e-7);  // six digits
    const KmCoefficients half{(yellow->K(i) + blue->K(i)) / 2, (yellow->S(i) + blue->S(i)) / 2};
    EXPECT_NEAR(km_over(km_film(half, 2), .9), mixed[i], 5.01e-7);
  }
}

struct Pick {
  const char* name;
  float srgb[3];
  float opacity;
};
TEST(PigmentLibrary, OilColoursReproduceTheirPickedColours) {
  constexpr Pick kPicks[] = {{"Titanium White", {.930f, .922f, .871f}, .80f},
                             {"Yellow Ochre", {.527f, .254f, .025f}, .70f},
                             {"Ultramarine Blue", {.019f, .030f, .323f}, .40f},
                             {"Viridian", {.012f, .147f, .093f}, .30f}};
  for (const Pick& pick : kPicks) {
    const Pigment* p = find_library_pigment(pick.name);
    ASSERT_NE(p, nullptr);
    for (int i = 0; i < 3; ++i) {
      const KmFilm film = km_film({p->K(i), p->S(i)}, 1);
      EXPECT_NEAR(km_over(film, 1), pick.srgb[i], 1e-3);  // picks rounded to three digits
      const float over_black = std::max(pick.opacity * pick.srgb[i], 1 / 255.0f);
      EXPECT_NEAR(film.R, over_black, 1e-3);
    }
  }
}

}  // namespace
}  // namespace pentimento
