#include <algorithm>
#include <array>

#include "formats/import/read/readers.h"
#include "formats/import/sketch/recording.h"

namespace pentimento::sketch {

namespace {
constexpr std::array kFormats = {
    Format{"remarkable", "page of a reMarkable tablet", ".rm", is_remarkable, read_remarkable},
    Format{"tilt-brush", "painting of Tilt Brush or Open Brush", ".tilt", is_tilt_brush,
           read_tilt_brush},
    Format{"a-painter", "A-Painter painting in space", ".apa", is_a_painter, read_a_painter},
    Format{"wacom", "Wacom Universal Ink Model", ".uim .json", is_wacom, read_wacom},
    Format{"artrage", "ArtRage script", ".arscript", is_artrage, read_artrage},
    Format{"drawpile", "Drawpile text recording", ".dptxt", is_drawpile, read_drawpile},
    Format{"inkml", "W3C Ink Markup Language", ".inkml", is_inkml, read_inkml},
    Format{"excalidraw", "Excalidraw scene or library", ".excalidraw .excalidrawlib", is_excalidraw,
           read_excalidraw},
    Format{"pointer-json", "pointer events of a browser", ".json", is_pointer_json,
           read_pointer_json},
    Format{"svc", "handwriting samples (BDALab)", ".svc", is_svc, read_svc},
    Format{"mypaint", "MyPaint event recording", ".dat", is_mypaint, read_mypaint},
    Format{"csv", "table of samples", ".csv .tsv .txt", is_csv, read_csv},
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
