#include "replay/commands/file_info.h"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <string_view>
#include <utility>

#include "replay/job/report_object.h"

namespace pentimento {

namespace {
/// Whether the first bytes are those of a PNG, an EXR or an HDF5 file.
bool starts_like_an_output(const std::string& path) {
  constexpr std::array<std::string_view, 3> kMagic = {"\x89PNG", "\x76\x2f\x31\x01", "\x89HDF"};
  std::array<char, 4> first{};
  std::ifstream file(path, std::ios::binary);
  file.read(first.data(), first.size());
  for (const std::string_view magic : kMagic) {
    if (std::string_view(first.data(), first.size()) == magic) return true;
  }
  return false;
}

std::string counts_json(const std::map<std::string, std::int64_t>& counts) {
  ReportObject json;
  for (const auto& [name, count] : counts) json.add(name, count);
  return json.text();
}

std::string strings_json(const std::vector<std::string>& strings) {
  std::vector<std::string> items;
  for (const std::string& s : strings) items.push_back(json_string(s));
  return json_array(items);
}

std::string map_json(const std::map<std::string, std::string>& map) {
  ReportObject json;
  for (const auto& [key, value] : map) json.add(key, value);
  return json.text();
}

void add_log(const LogFacts& log, ReportObject& json) {
  const log::Header& h = log.header;
  json.add("kind", "log")
      .add("version", h.version)
      .add("title", h.title)
      .add("author", h.author)
      .add("recorded_by", h.recorded_by)
      .add("recorded_at", h.recorded_at)
      .add("canvas_width_m", h.canvas_width_m)
      .add("canvas_height_m", h.canvas_height_m)
      .add("grid_width", h.grid_width)
      .add("grid_height", h.grid_height)
      .add("steps_per_second", h.steps_per_second)
      .add("stepped", log.summary.own_steps)
      .add("events", log.summary.event_count)
      .add_json("events_by_type", counts_json(log.summary.events))
      .add("strokes", log.summary.strokes)
      .add("undone", log.undone)
      .add("steps", log.steps)
      .add("duration_s", log.summary.duration_s())
      .add_json("pigments", strings_json(log.pigments))
      .add_json("marks", strings_json(log.summary.marks))
      .add_json("files", map_json(log.files))
      .add("log_sha256", log.summary.sha256);
  if (!log.summary.salvaged.empty()) json.add("salvaged", log.summary.salvaged);
}

void add_output(const FileDescription& output, ReportObject& json) {
  json.add("kind", output.format == "hdf5" ? "state" : "picture")
      .add("format", output.format)
      .add("width", output.width)
      .add("height", output.height)
      .add("bits", output.bits)
      .add("dpi", output.dpi)
      .add("samples", output.samples)
      .add("profile", output.profile);
  ReportObject provenance;
  for (const auto& [key, value] : output.provenance) provenance.add(key, value);
  json.add_json("provenance", provenance.text());
}

std::string log_text(const LogFacts& log) {
  const log::Header& h = log.header;
  std::string text = fmt::format("action log, version {}\n", h.version);
  const auto line = [&](std::string_view key, const std::string& value) {
    if (!value.empty()) text += fmt::format("{:<12} {}\n", key, value);
  };
  line("title", h.title);
  line("author", h.author);
  line("recorded by", h.recorded_by);
  line("recorded at", h.recorded_at);
  line("canvas", fmt::format("{} x {} m", h.canvas_width_m, h.canvas_height_m));
  line("grid", fmt::format("{} x {} cells", h.grid_width, h.grid_height));
  line("duration",
       fmt::format(
           "{} s, {} steps{}", log.summary.duration_s(), log.steps,
           log.summary.own_steps ? " of its own" : fmt::format(" of 1/{} s", h.steps_per_second)));
  line("events", fmt::format("{}", log.summary.event_count));
  for (const auto& [name, count] : log.summary.events)
    text += fmt::format("  {:<12} {}\n", name, count);
  line("strokes", fmt::format("{} ({} strokes, dryings, clearings or loads undone)",
                              log.summary.strokes, log.undone));
  line("pigments", fmt::format("{}", log.pigments.size()));
  for (const std::string& name : log.pigments) text += fmt::format("  {}\n", name);
  for (const std::string& name : log.summary.marks) line("mark", name);
  for (const auto& [name, sha256] : log.files) line("file", name + "  " + sha256);
  line("sha256", log.summary.sha256);
  line("salvaged", log.summary.salvaged);
  return text;
}

std::string output_text(const FileDescription& output) {
  std::string text =
      fmt::format("{}, {} x {}, {}\n", output.format, output.width, output.height, output.samples);
  if (output.dpi > 0) text += fmt::format("{} dots per inch\n", output.dpi);
  if (!output.profile.empty()) text += fmt::format("colours: {}\n", output.profile);
  for (const auto& [key, value] : output.provenance) {
    text += fmt::format("{:<24} {}\n", key, value);
  }
  return text;
}
}  // namespace

Result<FileInfo> file_info(const std::string& path, const log::ReaderOptions& reading) {
  FileInfo info;
  info.file = path;
  if (path != "-" && starts_like_an_output(path)) {
    Result<FileDescription> output = describe_file(path);
    if (!output) return output.error();
    info.output = std::move(*output);
  } else {
    Result<LogFacts> log = validate_log(path, reading);
    if (!log) return log.error();
    info.log = std::move(*log);
  }
  return info;
}

std::string info_json(const FileInfo& info) {
  ReportObject json;
  json.add("file", info.file);
  if (info.log) add_log(*info.log, json);
  if (info.output) add_output(*info.output, json);
  return json.text();
}

std::string info_text(const FileInfo& info) {
  return info.log ? log_text(*info.log) : output_text(*info.output);
}

}  // namespace pentimento
