#pragma once
// Reads a whole log, with the files it names, and plays nothing.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "formats/log/reader.h"
#include "formats/log/summary.h"

namespace pentimento {

struct LogFacts {
  log::Header header;
  log::Summary summary;
  std::int64_t undone = 0;  // strokes, dryings, clearings and loads that are not played
  std::int64_t steps = 0;
  std::vector<std::string> pigments;         // of header and picked
  std::map<std::string, std::string> files;  // named by the log: SHA-256
};

/// Errors: the log's and its files'.
Result<LogFacts> validate_log(const std::string& path, const log::ReaderOptions& reading);

}  // namespace pentimento
