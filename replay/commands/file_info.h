#pragma once
// `pentimento info`: finds out from a file's content what it is and holds.

#include <optional>
#include <string>

#include "core/base/result.h"
#include "formats/io/provenance.h"
#include "replay/commands/validate.h"

namespace pentimento {

/// What a file holds: `log` or `output` is set.
struct FileInfo {
  std::string file;
  std::optional<LogFacts> log;
  std::optional<FileDescription> output;  // a picture or a state dump
};

/// Describes a file. Errors: those of its kind of file.
Result<FileInfo> file_info(const std::string& path, const log::ReaderOptions& reading);

std::string info_json(const FileInfo& info);
std::string info_text(const FileInfo& info);

}  // namespace pentimento
