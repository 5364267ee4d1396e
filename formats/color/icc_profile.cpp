#include "formats/color/icc_profile.h"

#include <lcms2.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/base/require_memory.h"

namespace pentimento {

namespace {

constexpr double kVersion = 4.3;                          // whatever the library's own
constexpr std::size_t kDateOffset = 24, kDateBytes = 12;  // ICC.1 7.2.8: the header's date
constexpr std::array<cmsTagSignature, 3> kColorants = {cmsSigRedColorantTag, cmsSigGreenColorantTag,
                                                       cmsSigBlueColorantTag};
constexpr std::array<cmsTagSignature, 3> kCurves = {cmsSigRedTRCTag, cmsSigGreenTRCTag,
                                                    cmsSigBlueTRCTag};

struct CloseProfile {
  void operator()(void* profile) const { cmsCloseProfile(profile); }
};
using IccHandle = std::unique_ptr<void, CloseProfile>;
struct FreeCurve {
  void operator()(cmsToneCurve* curve) const { cmsFreeToneCurve(curve); }
};
using IccCurve = std::unique_ptr<cmsToneCurve, FreeCurve>;
struct FreeText {
  void operator()(cmsMLU* text) const { cmsMLUfree(text); }
};

IccCurve curve_of(ColorProfile profile) {
  if (profile == ColorProfile::kAdobeRgb) return IccCurve(cmsBuildGamma(nullptr, 563.0 / 256));
  constexpr cmsInt32Number kLinearThenPower = 4;
  const double srgb[] = {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045};
  return IccCurve(cmsBuildParametricToneCurve(nullptr, kLinearThenPower, srgb));
}

void write_text(const IccHandle& profile, cmsTagSignature tag, std::string_view text) {
  const std::unique_ptr<cmsMLU, FreeText> words(cmsMLUalloc(nullptr, 1));
  cmsMLUsetASCII(words.get(), "en", "US", std::string(text).c_str());
  require_memory(cmsWriteTag(profile.get(), tag, words.get()) != 0);
}

IccHandle make(ColorProfile of) {
  const Primaries& p = primaries_of(of);
  const cmsCIExyY white = {kWhiteD65[0], kWhiteD65[1], 1};
  const cmsCIExyYTRIPLE primaries = {
      {p[0][0], p[0][1], 1}, {p[1][0], p[1][1], 1}, {p[2][0], p[2][1], 1}};
  const IccCurve curve = curve_of(of);
  cmsToneCurve* curves[] = {curve.get(), curve.get(), curve.get()};
  IccHandle profile(cmsCreateRGBProfile(&white, &primaries, curves));
  require_memory(profile != nullptr);
  cmsSetProfileVersion(profile.get(), kVersion);
  write_text(profile, cmsSigProfileDescriptionTag, profile_title(of));
  write_text(profile, cmsSigCopyrightTag, "No copyright, use freely");
  return profile;
}

std::vector<std::uint8_t> bytes_of(const IccHandle& profile) {
  cmsUInt32Number size = 0;
  require_memory(cmsSaveProfileToMem(profile.get(), nullptr, &size) != 0);
  std::vector<std::uint8_t> bytes(size);
  require_memory(cmsSaveProfileToMem(profile.get(), bytes.data(), &size) != 0);
  return bytes;
}

IccHandle open(std::span<const std::uint8_t> bytes) {
  return IccHandle(cmsOpenProfileFromMem(bytes.data(), static_cast<cmsUInt32Number>(bytes.size())));
}

bool alike(const IccHandle& a, const IccHandle& b) {
  constexpr double kColorantTolerance = 0.002;  // others round or adapt to D50 a little differently
  constexpr double kCurveTolerance = 0.003;     // below a code of 8 bits
  for (std::size_t c = 0; c < 3; ++c) {
    const auto* p = static_cast<const cmsCIEXYZ*>(cmsReadTag(a.get(), kColorants[c]));
    const auto* q = static_cast<const cmsCIEXYZ*>(cmsReadTag(b.get(), kColorants[c]));
    if (p == nullptr || q == nullptr) return false;
    if (std::max({std::abs(p->X - q->X), std::abs(p->Y - q->Y), std::abs(p->Z - q->Z)}) >
        kColorantTolerance)
      return false;
    const auto* f = static_cast<const cmsToneCurve*>(cmsReadTag(a.get(), kCurves[c]));
    const auto* g = static_cast<const cmsToneCurve*>(cmsReadTag(b.get(), kCurves[c]));
    if (f == nullptr || g == nullptr) return false;
    constexpr int kSamples = 64;
    for (int i = 0; i <= kSamples; ++i) {
      const auto v = static_cast<cmsFloat32Number>(i) / kSamples;
      const float difference = cmsEvalToneCurveFloat(f, v) - cmsEvalToneCurveFloat(g, v);
      if (static_cast<double>(std::abs(difference)) > kCurveTolerance) return false;
    }
  }
  return true;
}

std::string title_of(const IccHandle& profile) {
  std::array<char, 256> text{};
  cmsGetProfileInfoASCII(profile.get(), cmsInfoDescription, "en", "US", text.data(),
                         static_cast<cmsUInt32Number>(text.size()));
  return text.data();
}

}  // namespace

std::vector<std::uint8_t> icc_profile(ColorProfile profile) {
  std::vector<std::uint8_t> bytes = bytes_of(make(profile));
  // The library writes the present time. It is replaced by a fixed time, and then the profile's
  // identity is computed.
  constexpr std::array<std::uint8_t, kDateBytes> kDate = {7, 0xE8, 0, 1, 0, 1};  // 2024-01-01
  std::copy(kDate.begin(), kDate.end(), bytes.begin() + kDateOffset);
  const IccHandle dated = open(bytes);
  require_memory(dated != nullptr && cmsMD5computeID(dated.get()) != 0);
  return bytes_of(dated);
}

std::optional<IccDescription> describe_icc(std::span<const std::uint8_t> bytes) {
  const IccHandle profile = open(bytes);
  if (profile == nullptr || cmsGetColorSpace(profile.get()) != cmsSigRgbData) return std::nullopt;
  IccDescription out;
  out.title = title_of(profile);
  for (const ColorProfile known : kColorProfiles)
    if (!out.profile && alike(profile, make(known))) out.profile = known;
  return out;
}

}  // namespace pentimento
