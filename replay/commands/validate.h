#pragma once
// `pentimento validate`: reads a whole log and the files that it names, without replaying it.

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
  std::int64_t undone = 0;  // strokes, dryings, clearings and loads that are undone
  std::int64_t steps = 0;
  std::vector<std::string> pigments;         // those of the header, and picked colours
  std::vector<std::string> swatches;         // "#rrggbb" of each
  std::map<std::string, std::string> files;  // file named by the log -> SHA-256
};

/// Checks a log. Errors: those of the log and of its files.
Result<LogFacts> validate_log(const std::string& path, const log::ReaderOptions& reading);
/// The same of a log that was opened before and stands before its first event.
Result<LogFacts> validate_log(const std::string& path, log::Reader& reader,
                              const log::ReaderOptions& reading);

}  // namespace pentimento
