#pragma once
// `pentimento info`: what a file is and holds, told from its content.

#include <optional>
#include <string>

#include "core/base/result.h"
#include "formats/io/provenance.h"
#include "replay/commands/validate.h"

namespace pentimento {

/// One of the two.
struct FileInfo {
  std::string file;
  std::optional<LogFacts> log;
  std::optional<FileDescription> output;  // a picture or a state dump
};

/// Errors: of whichever kind of file it is.
Result<FileInfo> file_info(const std::string& path, const log::ReaderOptions& reading);

std::string info_json(const FileInfo& info);
std::string info_text(const FileInfo& info);

}  // namespace pentimento
