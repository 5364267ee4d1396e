#include <algorithm>
#include <array>

#include "formats/import/read/readers.h"
#include "formats/import/sketch/recording.h"

namespace pentimento::sketch {

namespace {
constexpr std::array kFormats = {
    Format{"artrage", "ArtRage script", ".arscript", is_artrage, read_artrage},
    Format{"drawpile", "Drawpile text recording", ".dptxt", is_drawpile, read_drawpile},
    Format{"inkml", "W3C Ink Markup Language", ".inkml", is_inkml, read_inkml},
    Format{"excalidraw", "Excalidraw scene or library", ".excalidraw .excalidrawlib", is_excalidraw,
           read_excalidraw},
    Format{"mypaint", "MyPaint event recording", ".dat", is_mypaint, read_mypaint},
};
}  // namespace

std::span<const Format> formats() {
  return kFormats;
}

const Format* find_format(std::string_view name) {
  const auto found = std::find_if(kFormats.begin(), kFormats.end(),
                                  [&](const Format& f) { return f.name == name; });
  return found == kFormats.end() ? nullptr : &*found;
}

const Format* format_of(std::string_view bytes) {
  const auto found =
      std::find_if(kFormats.begin(), kFormats.end(), [&](const Format& f) { return f.is(bytes); });
  return found == kFormats.end() ? nullptr : &*found;
}

}  // namespace pentimento::sketch
