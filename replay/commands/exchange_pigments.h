#pragma once
// Other paints for the palette of a state dump: the same strokes in other colours, without
// simulation. What is dry keeps its colour, since its paint is not known any more.

#include <string>
#include <vector>

#include "core/base/result.h"
#include "formats/hdf5/state_dump.h"
#include "formats/log/tables/events.h"

namespace pentimento {

struct PigmentExchange {
  std::string pigment;     // of the dump
  log::PigmentSpec paint;  // what takes its place
};

/// `FILE`, whose pigments replace those of the same name, or `NAME=PAINT,...`, where a paint is a
/// pigment of the library or a colour `#rrggbb`. Errors: kUsage, and those of the file.
Result<std::vector<PigmentExchange>> parse_exchanges(const std::string& text);

/// Puts the paints in place of the dump's. Errors: kBadInput where a dump has optical channels,
/// which no longer know their pigments; kUsage for a pigment that the dump does not have.
Result<void> exchange_pigments(const std::vector<PigmentExchange>& exchanges, StateDump& dump);

}  // namespace pentimento
