#include "core/optics/paints/pigment_library.h"

#include <array>
#include <string>
#include <vector>

#include "core/optics/plain_name.h"
#include "core/optics/spectral/measured_paints.h"

namespace pentimento {
namespace {

struct NamedPigment {
  std::string_view name;
  std::array<double, 3> K;
  std::array<double, 3> S;
};

// Curtis, Anderson, Seims, Fleischer, Salesin: Computer-Generated Watercolor, SIGGRAPH 97, fig. 5.
// The oil colours: pick (sRGB) and opacity in the comment, K and S rounded to four digits.
constexpr NamedPigment kLibrary[] = {
    {"Quinacridone Rose", {0.22, 1.47, 0.57}, {0.05, 0.003, 0.03}},
    {"Indian Red", {0.46, 1.07, 1.50}, {1.28, 0.38, 0.21}},
    {"Cadmium Yellow", {0.10, 0.36, 3.45}, {0.97, 0.65, 0.007}},
    {"Hooker's Green", {1.62, 0.61, 1.64}, {0.01, 0.012, 0.003}},
    {"Cerulean Blue", {1.52, 0.32, 0.25}, {0.06, 0.26, 0.40}},
    {"Burnt Umber", {0.74, 1.54, 2.10}, {0.09, 0.09, 0.004}},
    {"Cadmium Red", {0.14, 1.08, 1.68}, {0.77, 0.015, 0.018}},
    {"Brilliant Orange", {0.13, 0.81, 3.45}, {0.005, 0.009, 0.007}},
    {"Hansa Yellow", {0.06, 0.21, 1.78}, {0.50, 0.88, 0.009}},
    {"Phthalo Green", {1.55, 0.47, 0.63}, {0.01, 0.05, 0.035}},
    {"French Ultramarine", {0.86, 0.86, 0.06}, {0.005, 0.005, 0.09}},
    {"Interference Lilac", {0.08, 0.11, 0.07}, {1.25, 0.42, 1.43}},
    {"Titanium White", {0.03927, 0.04464, 0.07875}, {3.268, 3.195, 2.818}},    // #f7f6f0 .80
    {"Zinc White", {0.04187, 0.04187, 0.05658}, {0.9125, 0.9125, 0.8858}},     // #f6f6f3 .50
    {"Ivory Black", {3.283, 3.346, 3.379}, {0.07433, 0.06741, 0.06407}},       // #1d1b1a .90
    {"Yellow Ochre", {0.4038, 0.9187, 2.366}, {0.9987, 0.5331, 0.08711}},      // #c08a2c .70
    {"Raw Sienna", {0.5324, 1.115, 2.141}, {0.3743, 0.1852, 0.04616}},         // #a86b2a .45
    {"Burnt Sienna", {0.7913, 1.799, 2.445}, {0.274, 0.07555, 0.02911}},       // #8a3b1e .45
    {"Raw Umber", {1.376, 1.736, 2.149}, {0.2231, 0.1411, 0.07996}},           // #5e4630 .60
    {"Alizarin Crimson", {0.6995, 2.872, 2.028}, {0.1391, 0.02277, 0.02312}},  // #8e1429 .25
    {"Vermilion", {0.2425, 2.326, 2.891}, {1.887, 0.1469, 0.06497}},           // #d8361f .80
    {"Naples Yellow", {0.07875, 0.2656, 0.9889}, {2.818, 1.807, 0.7118}},      // #f0d58c .80
    {"Lemon Yellow", {0.03722, 0.1605, 1.9}, {1.116, 0.876, 0.09452}},         // #f7e03a .55
    {"Viridian", {2.417, 1.049, 1.299}, {0.01925, 0.1135, 0.08228}},           // #1c6b56 .30
    {"Chromium Oxide Green", {1.66, 1.215, 2.203}, {0.3387, 0.5566, 0.1731}},  // #5b7a3c .80
    {"Cobalt Blue", {2.461, 1.511, 0.544}, {0.03442, 0.1334, 0.4354}},         // #1f4fa8 .50
    {"Prussian Blue", {2.872, 1.88, 1.37}, {0.02277, 0.02884, 0.05924}},       // #14304f .25
    {"Ultramarine Blue", {2.196, 1.974, 0.6343}, {0.035, 0.04867, 0.2782}},    // #26309a .40
    {"Cobalt Violet", {0.9397, 1.729, 0.7449}, {0.2293, 0.08326, 0.2897}},     // #7b3f8f .45
};
constexpr std::size_t kCount = std::size(kLibrary);

constexpr std::array<std::string_view, kCount> kNames = [] {
  std::array<std::string_view, kCount> names;
  for (std::size_t i = 0; i < kCount; ++i) names[i] = kLibrary[i].name;
  return names;
}();

std::vector<Pigment> make_pigments() {
  std::vector<Pigment> pigments;
  for (const NamedPigment& e : kLibrary) {
    pigments.push_back({std::string(e.name), Eigen::Map<const Eigen::Vector3d>(e.K.data()),
                        Eigen::Map<const Eigen::Vector3d>(e.S.data())});
  }
  return pigments;
}

}  // namespace

const Pigment* find_library_pigment(std::string_view name) {
  static const std::vector<Pigment> pigments = make_pigments();
  const std::string wanted = plain_name(name);
  for (const Pigment& p : pigments) {
    if (plain_name(p.name) == wanted) return &p;
  }
  return nullptr;
}

bool in_pigment_library(std::string_view name) {
  return find_library_pigment(name) != nullptr || find_measured_paint(name) != nullptr;
}

std::span<const std::string_view> rgb_pigment_names() {
  return kNames;
}

std::span<const std::string_view> library_pigment_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> all(kNames.begin(), kNames.end());
    for (const SpectralPaint& paint : measured_paints()) all.push_back(paint.name);
    return all;
  }();
  return names;
}

}  // namespace pentimento
