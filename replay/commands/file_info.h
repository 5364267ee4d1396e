#pragma once
// `pentimento info`: finds out from a file's content what it is and holds.

#include <optional>
#include <string>

#include "core/base/result.h"
#include "formats/import/sketch/sketch.h"
#include "formats/io/provenance.h"
#include "formats/log/stroke_preview.h"
#include "replay/commands/validate.h"

namespace pentimento {

/// What a file holds: `log`, `output` or `recording` is set.
struct FileInfo {
  /// Another program's recording, and the log that `convert` makes of it.
  struct Recording {
    std::string format, title;
    std::int64_t strokes = 0, samples = 0;  // of the file
    sketch::Report report;
    LogFacts log;
  };
  std::string file;
  std::optional<LogFacts> log;
  std::optional<Recording> recording;
  std::optional<log::StrokePreview> preview;  // of a log or a recording
  std::optional<FileDescription> output;      // a picture or a state dump
};

/// Describes a file; `-` is a log or a recording on standard input. With a preview of that many
/// characters a row, unless it is 0 or a log comes from a pipe. Errors: those of its kind of file;
/// kBadInput for a file of no kind that is known.
Result<FileInfo> file_info(const std::string& path, const log::ReaderOptions& reading,
                           int preview_columns = 0);

std::string info_json(const FileInfo& info);
/// With a preview it is for a terminal: colours are shown, too.
std::string info_text(const FileInfo& info);

}  // namespace pentimento
