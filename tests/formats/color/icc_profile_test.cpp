#include "formats/color/icc_profile.h"

#include <gtest/gtest.h>
#include <lcms2.h>

namespace pentimento {
namespace {

class IccOf : public testing::TestWithParam<ColorProfile> {};
INSTANTIATE_TEST_SUITE_P(Profiles, IccOf, testing::ValuesIn(kColorProfiles));

TEST_P(IccOf, IsRecognisedWithItsTitle) {
  const auto described = describe_icc(icc_profile(GetParam()));
  ASSERT_TRUE(described);
  EXPECT_EQ(described->profile, GetParam());
  EXPECT_EQ(described->title, profile_title(GetParam()));
}

TEST_P(IccOf, HasTheSameBytesEachTimeAndNamesItself) {
  const auto bytes = icc_profile(GetParam());
  EXPECT_EQ(bytes, icc_profile(GetParam()));
  EXPECT_LT(bytes.size(), 1000u);  // three curves in one, no tables
  // ICC.1, 7.2: size, 'acsp', version 4.3, display class, and an identity that is not nothing.
  EXPECT_EQ(bytes.size(), static_cast<std::size_t>(bytes[2]) << 8 | bytes[3]);
  EXPECT_EQ(std::string(bytes.begin() + 36, bytes.begin() + 40), "acsp");
  // 7.2.8: made on 1 January 2024, whatever the day is.
  EXPECT_EQ(std::vector<std::uint8_t>(bytes.begin() + 24, bytes.begin() + 36),
            (std::vector<std::uint8_t>{7, 0xE8, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(bytes[8], 4);
  EXPECT_EQ(bytes[9], 0x30);
  EXPECT_EQ(std::string(bytes.begin() + 12, bytes.begin() + 16), "mntr");
  EXPECT_NE(std::vector<std::uint8_t>(bytes.begin() + 84, bytes.begin() + 100),
            std::vector<std::uint8_t>(16, 0));
}

TEST(IccProfile, TheLibrarysOwnSrgbIsRecognised) {
  cmsHPROFILE profile = cmsCreate_sRGBProfile();
  cmsUInt32Number size = 0;
  ASSERT_TRUE(cmsSaveProfileToMem(profile, nullptr, &size));
  std::vector<std::uint8_t> bytes(size);
  ASSERT_TRUE(cmsSaveProfileToMem(profile, bytes.data(), &size));
  cmsCloseProfile(profile);
  ASSERT_TRUE(describe_icc(bytes));
  EXPECT_EQ(describe_icc(bytes)->profile, ColorProfile::kSrgb);
}

TEST(IccProfile, AnotherGammaIsAnotherProfile) {
  const cmsCIExyY white = {0.3127, 0.3290, 1};
  const cmsCIExyYTRIPLE primaries = {{0.64, 0.33, 1}, {0.30, 0.60, 1}, {0.15, 0.06, 1}};
  cmsToneCurve* curve = cmsBuildGamma(nullptr, 1.8);
  cmsToneCurve* curves[] = {curve, curve, curve};
  cmsHPROFILE profile = cmsCreateRGBProfile(&white, &primaries, curves);
  cmsUInt32Number size = 0;
  ASSERT_TRUE(cmsSaveProfileToMem(profile, nullptr, &size));
  std::vector<std::uint8_t> bytes(size);
  ASSERT_TRUE(cmsSaveProfileToMem(profile, bytes.data(), &size));
  cmsCloseProfile(profile);
  cmsFreeToneCurve(curve);
  ASSERT_TRUE(describe_icc(bytes));
  EXPECT_FALSE(describe_icc(bytes)->profile);
}

TEST(IccProfile, DamageIsNoProfileAndNoHarm) {
  EXPECT_FALSE(describe_icc({}));
  const auto bytes = icc_profile(ColorProfile::kDisplayP3);
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    auto cut = bytes;
    cut.resize(n);
    describe_icc(cut);
    auto flipped = bytes;
    flipped[n] ^= 0xFF;
    describe_icc(flipped);
  }
}

}  // namespace
}  // namespace pentimento
