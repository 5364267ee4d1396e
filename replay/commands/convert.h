#pragma once
// `pentimento convert`: another program's recording becomes an action log.

#include <string>

#include "core/base/result.h"
#include "formats/import/recording.h"
#include "formats/import/sketch_log.h"

namespace pentimento {

struct ConvertJob {
  std::string input;
  std::string output = "-";  // standard output
  std::string format;        // of formats(); empty: told from the content
  sketch::ReadOptions reading;
  sketch::LogOptions writing;
  bool no_clobber = false;
};

struct ConvertFacts {
  std::string input, format, title;
  sketch::LogCounts counts;
  sketch::Report report;
  Published log;
};

/// Errors: kUsage (an unknown format), kBadInput, kLimit, kIo.
Result<ConvertFacts> convert(const ConvertJob& job);

std::string convert_json(const ConvertFacts& facts);
std::string convert_text(const ConvertFacts& facts);

}  // namespace pentimento
