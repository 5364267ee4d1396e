#pragma once
// The brushes that a log may name: those of its header and the built-in brushes.

#include <map>
#include <string>

#include "core/base/result.h"
#include "core/brush/brush_settings.h"
#include "formats/log/tables/events.h"
#include "replay/log/log_files.h"

namespace pentimento {

class BrushTable {
 public:
  /// Reads the header's tip textures. Errors: kBadInput or kIo, of a texture.
  static Result<BrushTable> make(const log::Header& header, LogFiles& files);
  /// The built-in brushes alone.
  BrushTable();

  /// The brush in the hand before the log names one: `round`.
  const BrushDefinition& first() const { return find("round"); }
  bool has(const std::string& name) const { return brushes_.contains(name); }
  /// The brush called `name`, which must be in the header or built in (the reader checks that).
  const BrushDefinition& find(const std::string& name) const;

 private:
  std::map<std::string, BrushDefinition> brushes_;
};

}  // namespace pentimento
