// A hill under the sky, painted from C++ without a log. usage: hill PICTURE.png
#include <cmath>
#include <cstdio>

#include "replay/commands/easel.h"

int main(int argc, char** argv) {
  using namespace pentimento;
  log::Header header;  // the canvas: 40 x 30 cm, a cell to a millimetre
  header.canvas_width_m = 0.4, header.canvas_height_m = 0.3;
  header.grid_width = 400, header.grid_height = 300;
  for (const char* name : {"Cerulean Blue", "Zinc White", "Chromium Oxide Green", "Yellow Ochre"})
    header.palette.push_back({.name = name, .library = true});
  const auto opened = Easel::open(header);
  if (!opened) return std::fprintf(stderr, "%s\n", opened.error().message.c_str()), 1;
  Easel& easel = **opened;

  BrushSettings sliders;
  sliders.size_m = 0.05f;
  easel.take_brush("bristle", sliders);
  for (int i = 0; i < 30; ++i) {  // the sky, paler towards the horizon, wet into wet
    const double x = 0.4 * std::fmod(0.618 * i, 1), y = 0.007 * i, sway = 0.01 * std::sin(2.4 * i);
    easel.take_color(i * 7 % 30 < i ? "Zinc White" : "Cerulean Blue");
    easel.stroke({{x - 0.12, y + sway}, {x, y - sway}, {x + 0.12, y}});
  }
  for (int i = 0; i < 70; ++i) {  // the hill, from its ridge down, in short strokes that lean
    const double x = 0.4 * std::fmod(0.618 * i, 1), y = 0.2 - 0.05 * std::sin(6 * x) + 0.002 * i;
    easel.take_color(i % 5 == 0 ? "Yellow Ochre" : "Chromium Oxide Green");
    easel.stroke({{x - 0.03, y + 0.02 * std::sin(i)}, {x, y}, {x + 0.03, y - 0.01, 0.3f}});
  }
  const auto picture = easel.write_png(argc > 1 ? argv[1] : "hill.png");
  if (!picture) return std::fprintf(stderr, "%s\n", picture.error().message.c_str()), 1;
}
