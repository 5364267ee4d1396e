// Two sunflowers, painted from C++ without a log. usage: sunflowers PICTURE.png
#include <cmath>
#include <cstdio>

#include "replay/commands/easel.h"

using namespace pentimento;

namespace {
void take(Easel& easel, const char* brush, double size_m, const char* pigment,
          float medium = 0.9f) {
  BrushSettings sliders;
  sliders.size_m = static_cast<float>(size_m);
  sliders.medium_frac = medium;
  sliders.pigment_frac = 0.9f;
  easel.take_brush(brush, sliders);
  easel.take_color(pigment);
}

/// Short strokes to and fro, each into the wet ones above it; then it dries.
void wall(Easel& easel) {
  const char* colors[] = {"Cerulean Blue", "Cerulean Blue", "Viridian", "Cerulean Blue",
                          "Zinc White"};
  for (int i = 0; i < 110; ++i) {
    const double x = 0.4 * std::fmod(0.618 * i, 1), y = 0.004 * i, rise = 0.02 * std::sin(5.3 * i);
    take(easel, "bristle", 0.06, colors[i * i * 7 % 23 % 5], 0.4f);
    easel.stroke({{x - 0.04, y - rise}, {x, y}, {x + 0.04, y + rise}});
  }
  easel.dry();
}

void flower(Easel& easel, double x, double y, double r) {
  const auto at = [&](double out, double angle, float pressure = 0.8f) {
    return StrokePoint{x + r * out * std::cos(angle), y + r * out * std::sin(angle), pressure};
  };
  take(easel, "filbert", 0.2 * r, "Chromium Oxide Green");
  easel.stroke({{x, y}, {x + 0.02, y + 1.3 * r}, {x - 0.01, 0.42}});
  const char* rings[] = {"Yellow Ochre", "Cadmium Yellow", "Naples Yellow"};
  for (int i = 0; i < 54; ++i) {  // petals, pulled outwards; the angle is nearly the golden one
    const double angle = 2.4 * i, out = 1 - 0.1 * (i / 18) + 0.08 * std::sin(7 * i);
    take(easel, "filbert", 0.22 * r, rings[i / 18]);
    easel.stroke(
        {at(0.3, angle, 1), at(0.7 * out, angle + 0.15 * std::sin(3 * i)), at(out, angle, 0.1f)},
        0.3);
  }
  take(easel, "round", 0.3 * r, "Burnt Umber");
  for (int i = 0; i < 24; ++i)
    easel.stroke({at(0.06 * std::sqrt(i), 2.4 * i), at(0.07 * std::sqrt(i), 2.4 * i)});
  for (int i = 0; i < 60; ++i) {  // seeds, dabbed from the middle outwards
    take(easel, "round", 0.08 * r, i % 3 == 0 ? "Yellow Ochre" : "Burnt Sienna");
    easel.stroke({at(0.05 * std::sqrt(i), 2.4 * i)});
  }
}
}  // namespace

int main(int argc, char** argv) {
  log::Header header;
  header.canvas_width_m = header.canvas_height_m = 0.4;
  header.grid_width = header.grid_height = 560;
  for (const char* name :
       {"Cerulean Blue", "Viridian", "Zinc White", "Chromium Oxide Green", "Yellow Ochre",
        "Cadmium Yellow", "Naples Yellow", "Burnt Umber", "Burnt Sienna"}) {
    header.palette.emplace_back().name = name;
    header.palette.back().library = true;
  }
  Result<std::unique_ptr<Easel>> easel = Easel::open(header);
  if (!easel) return std::fprintf(stderr, "%s\n", easel.error().message.c_str()), 1;
  wall(**easel);
  flower(**easel, 0.27, 0.27, 0.11);
  flower(**easel, 0.15, 0.14, 0.13);
  const Result<Published> picture = (*easel)->write_png(argc > 1 ? argv[1] : "sunflowers.png", 432);
  if (!picture) return std::fprintf(stderr, "%s\n", picture.error().message.c_str()), 1;
}
