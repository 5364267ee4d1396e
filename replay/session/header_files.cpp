#include "replay/session/header_files.h"

#include <fmt/format.h>

#include "formats/image/read_image.h"
#include "replay/paper/paper_relief.h"

namespace pentimento {

namespace {
Result<void> check_paper(const log::PaperSpec& paper, LogFiles& files) {
  if (is_builtin_paper(paper.texture)) return {};
  const Result<std::string> path = files.use(paper.texture);
  if (!path) return path.error();
  if (const Result<Field<float>> picture = read_grey(*path); !picture) return picture.error();
  return {};
}

/// The header is the first line of a log.
Error in_header(const LogFiles& files, const Error& error) {
  const std::string& log = files.log_name();
  return {error.code, fmt::format("{}:1: {}", log == "-" ? "standard input" : log, error.message)};
}
}  // namespace

Result<BrushTable> open_header_files(const log::Header& header, LogFiles& files) {
  Result<BrushTable> brushes = BrushTable::make(header, files);
  if (!brushes) return in_header(files, brushes.error());
  if (const Result<void> paper = check_paper(header.paper, files); !paper)
    return in_header(files, paper.error());
  return brushes;
}

}  // namespace pentimento
