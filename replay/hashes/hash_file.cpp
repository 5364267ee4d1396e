#include "replay/hashes/hash_file.h"

#include <fmt/format.h>

#include <charconv>
#include <nlohmann/json.hpp>

#include "formats/log/stream/compress.h"
#include "formats/log/stream/line_source.h"

namespace pentimento {

namespace {
using nlohmann::json;
constexpr const char* kFormat = "pentimento-hashes";
constexpr int kVersion = 1;
constexpr std::int64_t kMostLineBytes = std::int64_t{1} << 28;

json header_object(const HashHeader& h) {
  return {{"format", kFormat},
          {"version", kVersion},
          {"log_sha256", h.log_sha256},
          {"software", h.software},
          {"command", h.command},
          {"grid", {h.width, h.height}},
          {"tile", {h.tile_width, h.tile_height}},
          {"fields", kHashedFields}};
}

/// As text without a JSON library, for it is written at every step.
std::string step_line(const StepHashes& step) {
  std::string text = fmt::format("{{\"step\":{},\"line\":{},\"fields\":[", step.step, step.line);
  for (std::size_t f = 0; f < step.fields.size(); ++f)
    text += fmt::format("{}\"{:016x}\"", f == 0 ? "" : ",", step.fields[f]);
  text += "],\"tiles\":[";
  for (std::size_t i = 0; i < step.tiles.size(); ++i)
    text +=
        fmt::format("{}[{},\"{:08x}\"]", i == 0 ? "" : ",", step.tiles[i].tile, step.tiles[i].hash);
  return text + "]}\n";
}

template <typename T>
T hexadecimal(const json& text) {
  const std::string digits = text.get<std::string>();
  T value = 0;
  const auto [end, problem] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (problem != std::errc() || end != digits.data() + digits.size())
    throw std::invalid_argument("not a hash");
  return value;
}

StepHashes step_of(const json& object) {
  StepHashes step;
  step.step = object.at("step").get<std::int64_t>();
  step.line = object.at("line").get<std::int64_t>();
  const json& fields = object.at("fields");
  if (fields.size() != step.fields.size()) throw std::invalid_argument("fields");
  for (std::size_t f = 0; f < step.fields.size(); ++f)
    step.fields[f] = hexadecimal<std::uint64_t>(fields.at(f));
  for (const json& tile : object.at("tiles"))
    step.tiles.push_back({tile.at(0).get<int>(), hexadecimal<std::uint32_t>(tile.at(1))});
  return step;
}
}  // namespace

struct HashWriter::Impl {
  std::unique_ptr<OutputFile> file;
  std::unique_ptr<log::ByteSink> sink;
};

HashWriter::HashWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
HashWriter::~HashWriter() = default;

Result<std::unique_ptr<HashWriter>> HashWriter::create(const std::string& path,
                                                       const HashHeader& header, bool no_clobber) {
  Result<std::unique_ptr<OutputFile>> file = OutputFile::create(path, no_clobber);
  if (!file) return file.error();
  auto impl = std::make_unique<Impl>();
  impl->file = std::move(*file);
  impl->sink = log::open_sink(*impl->file, log::compression_of(path), log::Effort::kLittle);
  impl->sink->write(header_object(header).dump(-1, ' ', false, json::error_handler_t::replace) +
                    "\n");
  return std::unique_ptr<HashWriter>(new HashWriter(std::move(impl)));
}

void HashWriter::write(const StepHashes& step) {
  impl_->sink->write(step_line(step));
}

Result<Published> HashWriter::complete() {
  impl_->sink->end();
  return impl_->file->complete();
}

Result<Published> HashWriter::publish() {
  return impl_->file->publish();
}

struct HashReader::Impl {
  std::string name;
  std::unique_ptr<log::LineSource> lines;
  HashHeader header;

  Error broken(const char* what) const {
    return {ErrorCode::kBadInput, fmt::format("{}:{}: {}", name, lines->line_number(), what)};
  }
  Result<std::optional<json>> object() const {
    Result<std::optional<log::Line>> line = lines->next();
    if (!line) return Error{line.error().code, fmt::format("{}: {}", name, line.error().message)};
    if (!*line) return std::optional<json>();
    json object = json::parse((*line)->text, nullptr, false);
    if (!object.is_object()) return broken("not a JSON object");
    return std::optional<json>(std::move(object));
  }
};

HashReader::HashReader(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
HashReader::~HashReader() = default;

const HashHeader& HashReader::header() const {
  return impl_->header;
}

Result<std::unique_ptr<HashReader>> HashReader::open(const std::string& path) {
  Result<std::unique_ptr<log::ByteSource>> bytes = log::ByteSource::open(path);
  if (!bytes) return bytes.error();
  auto impl = std::make_unique<Impl>();
  impl->name = path;
  log::ReaderOptions options;
  options.limits.max_line_bytes = kMostLineBytes;
  impl->lines = std::make_unique<log::LineSource>(std::move(*bytes), options);
  Result<std::optional<json>> first = impl->object();
  if (!first) return first.error();
  try {
    const json& object = first->value();
    if (object.at("format") != kFormat) return impl->broken("not a file of hashes");
    if (object.at("version") != kVersion)
      return impl->broken("a newer version than this program's");
    HashHeader& h = impl->header;
    h.log_sha256 = object.at("log_sha256").get<std::string>();
    h.software = object.at("software").get<std::string>();
    h.command = object.at("command").get<std::string>();
    h.width = object.at("grid").at(0).get<int>();
    h.height = object.at("grid").at(1).get<int>();
    h.tile_width = object.at("tile").at(0).get<int>();
    h.tile_height = object.at("tile").at(1).get<int>();
  } catch (const std::exception&) {
    return impl->broken("not a file of hashes");
  }
  return std::unique_ptr<HashReader>(new HashReader(std::move(impl)));
}

Result<std::optional<StepHashes>> HashReader::next() {
  Result<std::optional<json>> object = impl_->object();
  if (!object) return object.error();
  if (!*object) {
    if (impl_->lines->cut_short()) return impl_->broken("the file is cut short");
    return std::optional<StepHashes>();
  }
  try {
    return std::optional<StepHashes>(step_of(**object));
  } catch (const std::exception&) {
    return impl_->broken("not the hashes of a step");
  }
}

}  // namespace pentimento
