#include "formats/log/parse/palette_file.h"

#include <fmt/format.h>

#include "formats/io/utf8.h"
#include "formats/log/json/json_line.h"
#include "formats/log/parse/palette_parser.h"
#include "formats/log/stream/raw_file.h"

namespace pentimento::log {

namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 20;
constexpr int kMostDepth = 16;
constexpr std::size_t kMostProblemBytes = 300;  // a line that can still be read

Result<std::string> read_text(const std::string& path) {
  Result<std::unique_ptr<RawFile>> file = RawFile::open(path);
  if (!file) return file.error();
  std::string text(kMostBytes + 1, '\0');
  std::size_t size = 0;
  while (size < text.size()) {
    const Result<std::size_t> n = (*file)->read(std::span(text).subspan(size));
    if (!n) return n.error();
    if (*n == 0) break;
    size += *n;
  }
  if (size > kMostBytes)
    return Error{ErrorCode::kLimit,
                 fmt::format("{}: a palette of over {} bytes", path, kMostBytes)};
  text.resize(size);
  return text;
}

}  // namespace

Result<std::vector<PigmentSpec>> read_palette_file(const std::string& path) {
  const Result<std::string> text = read_text(path);
  if (!text) return text.error();
  const auto bad = [&](const std::string& what) {
    return Error{ErrorCode::kBadInput,
                 path + ": " + brief_line(valid_utf8(what), kMostProblemBytes)};
  };
  // Nodes point into the text, which the parser reads a little past. A log's first line stands by
  // itself.
  std::string padded = *text;
  padded.append(JsonLine::kPadding, '\0');
  const std::string_view whole(padded.data(), text->size());
  JsonLine json;
  std::string problem = json.parse(whole.substr(0, whole.find('\n')), kMostDepth);
  if (!problem.empty()) problem = json.parse(whole, kMostDepth);
  if (!problem.empty()) return bad(problem);
  Fields fields(json, json.nodes()[0]);
  std::vector<PigmentSpec> palette = parse_palette(fields);
  if (!fields.ok()) return bad(fields.problem());
  if (palette.empty()) return bad("has no palette");
  return palette;
}

}  // namespace pentimento::log
