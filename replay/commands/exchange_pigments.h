#pragma once
// Exchanges the paints in the palette of a state dump: the same strokes in other colours, without
// simulation. Dry paint keeps its colour, for the dump does not tell its pigments.

#include <string>
#include <vector>

#include "core/base/result.h"
#include "formats/hdf5/state_dump.h"
#include "formats/log/tables/events.h"

namespace pentimento {

struct PigmentExchange {
  std::string pigment;     // of the dump
  log::PigmentSpec paint;  // the paint that takes its place
};

/// Parses `FILE`, whose pigments replace those of the same name, or `NAME=PAINT,...`, where a paint
/// is a pigment of the library or a colour `#rrggbb`. Errors: kUsage, and those of the file.
Result<std::vector<PigmentExchange>> parse_exchanges(const std::string& text);

/// Puts the paints in the place of the dump's. Errors: kBadInput for a dump with optical channels,
/// which do not tell the pigments; kUsage for a pigment that the dump does not have.
Result<void> exchange_pigments(const std::vector<PigmentExchange>& exchanges, StateDump& dump);

}  // namespace pentimento
