// Two sunflowers, painted from C++ without a log. usage: sunflowers PICTURE.png
#include <cmath>
#include <cstdio>

#include "replay/easel.h"

using namespace pentimento;

int main(int argc, char** argv) {
  log::Header header;
  header.canvas_width_m = 0.4, header.canvas_height_m = 0.4;
  header.grid_width = 640, header.grid_height = 640;
  for (const char* name : {"Cerulean Blue", "Titanium White", "Viridian", "Chromium Oxide Green", "Burnt Umber",
                           "Yellow Ochre", "Cadmium Yellow", "Naples Yellow", "Burnt Sienna"}) {
    log::PigmentSpec& pigment = header.palette.emplace_back();
    pigment.name = name, pigment.library = true;
  }
  Result<std::unique_ptr<Easel>> opened = Easel::open(header);
  if (!opened) return std::fprintf(stderr, "%s\n", opened.error().message.c_str()), 1;
  Easel& easel = **opened;
  const auto take = [&](const char* brush, float size_m, const char* color, float medium = 0.6f) {
    BrushSettings sliders;
    sliders.size_m = size_m, sliders.medium_frac = medium, sliders.pigment_frac = 0.9f;
    easel.take_brush(brush, sliders);
    easel.take_color(color);
  };
  // The wall: short crossing strokes, each into the wet ones before.
  for (int i = 0; i < 150; ++i) {
    const double x = 0.4 * std::fmod(0.618 * i, 1), y = 0.42 * (i + 0.5) / 150, a = 0.9 * std::sin(5.3 * i);
    take("bristle", 0.05f, i % 3 == 0 ? "Titanium White" : i % 3 == 1 ? "Cerulean Blue" : "Viridian", 0.4f);
    easel.stroke({{x - 0.03, y - 0.03 * a}, {x, y}, {x + 0.03, y + 0.03 * a}});
  }
  easel.dry();
  const auto flower = [&](double x, double y, double r) {
    take("filbert", static_cast<float>(0.16 * r), "Chromium Oxide Green", 0.8f);
    easel.stroke({{x, y}, {x + 0.02, y + 1.3 * r}, {x - 0.01, 0.42}});
    for (int i = 0; i < 52; ++i) {  // three rings of petals, the lightest on top
      const char* colors[] = {"Yellow Ochre", "Cadmium Yellow", "Naples Yellow"};
      take("filbert", static_cast<float>(0.22 * r), colors[i / 19], 0.9f);
      const double a = 2.4 * i, out = r * (1 - 0.1 * (i / 19) + 0.08 * std::sin(7.0 * i)), bend = 0.15 * std::sin(3.0 * i);
      easel.stroke({{x + 0.35 * r * std::cos(a), y + 0.35 * r * std::sin(a), 1},
                    {x + 0.7 * out * std::cos(a + bend), y + 0.7 * out * std::sin(a + bend), 0.8f},
                    {x + out * std::cos(a), y + out * std::sin(a), 0.1f}}, 0.3);
    }
    for (int i = 0; i < 90; ++i) {  // seeds, dabbed from the middle outwards
      take("round", static_cast<float>(0.09 * r), i < 60 ? "Burnt Umber" : i % 3 == 0 ? "Yellow Ochre" : "Burnt Sienna", 1);
      const double a = 2.4 * i, d = 0.042 * r * std::sqrt(i);
      easel.stroke({{x + d * std::cos(a), y + d * std::sin(a)}});
    }
  };
  flower(0.27, 0.27, 0.11);
  flower(0.15, 0.14, 0.13);
  const Result<Published> written = easel.write_png(argc > 1 ? argv[1] : "sunflowers.png");
  if (!written) return std::fprintf(stderr, "%s\n", written.error().message.c_str()), 1;
}
