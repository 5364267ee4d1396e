#pragma once
// The readers of all formats, for the table in formats.cpp. Each lies in a file of its own, whose
// head says where the format is described and what becomes of its properties.

#include "formats/import/sketch/recording.h"

namespace pentimento::sketch {

bool is_artrage(std::string_view bytes);
Result<Sketch> read_artrage(const Source& source, const ReadOptions& options);

bool is_drawpile(std::string_view bytes);
Result<Sketch> read_drawpile(const Source& source, const ReadOptions& options);

bool is_excalidraw(std::string_view bytes);
Result<Sketch> read_excalidraw(const Source& source, const ReadOptions& options);

bool is_inkml(std::string_view bytes);
Result<Sketch> read_inkml(const Source& source, const ReadOptions& options);

bool is_mypaint(std::string_view bytes);
Result<Sketch> read_mypaint(const Source& source, const ReadOptions& options);

bool is_svc(std::string_view bytes);
Result<Sketch> read_svc(const Source& source, const ReadOptions& options);

bool is_pointer_json(std::string_view bytes);
Result<Sketch> read_pointer_json(const Source& source, const ReadOptions& options);

bool is_csv(std::string_view bytes);
Result<Sketch> read_csv(const Source& source, const ReadOptions& options);

bool is_a_painter(std::string_view bytes);
Result<Sketch> read_a_painter(const Source& source, const ReadOptions& options);

bool is_wacom(std::string_view bytes);
Result<Sketch> read_wacom(const Source& source, const ReadOptions& options);

bool is_tilt_brush(std::string_view bytes);
Result<Sketch> read_tilt_brush(const Source& source, const ReadOptions& options);

bool is_remarkable(std::string_view bytes);
Result<Sketch> read_remarkable(const Source& source, const ReadOptions& options);

}  // namespace pentimento::sketch
