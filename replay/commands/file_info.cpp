#include "replay/commands/file_info.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string_view>
#include <utility>

#include "formats/import/recording_file.h"
#include "formats/import/sketch/recording.h"
#include "formats/import/sketch/sketch_log.h"
#include "formats/io/sha256.h"
#include "formats/io/utf8.h"
#include "formats/log/stream/log_start.h"
#include "formats/log/write/writer.h"
#include "replay/job/report_object.h"
#include "replay/log/swatch.h"

namespace pentimento {

namespace {
/// Whether the first bytes are those of a PNG, an EXR or an HDF5 file.
bool are_of_an_output(std::string_view bytes) {
  constexpr std::array<std::string_view, 3> kMagic = {"\x89PNG", "\x76\x2f\x31\x01", "\x89HDF"};
  return std::any_of(kMagic.begin(), kMagic.end(),
                     [&](std::string_view magic) { return bytes.starts_with(magic); });
}

bool starts_like_an_output(const std::string& path) {
  std::array<char, 4> first{};
  std::ifstream file(path, std::ios::binary);
  file.read(first.data(), first.size());
  return are_of_an_output({first.data(), first.size()});
}

/// Whether the bytes may be a log that somebody spoilt: there are none, or they begin as JSON does,
/// perhaps after a mark of their encoding. The reader of logs says what is wrong with it then.
bool may_be_a_log(std::string_view bytes) {
  constexpr std::array<std::string_view, 3> kEncodingMarks = {"\xef\xbb\xbf", "\xff\xfe",
                                                              "\xfe\xff"};
  if (std::any_of(kEncodingMarks.begin(), kEncodingMarks.end(),
                  [&](std::string_view mark) { return bytes.starts_with(mark); }))
    return true;
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos || bytes[first] == '{';
}

std::string shown_name(const std::string& path) {
  return path == "-" ? "standard input" : path;
}

/// Takes the log of a recording, and keeps only its sums and its preview.
class FactsWriter : public log::Writer {
 public:
  explicit FactsWriter(int preview_columns) : columns_(preview_columns) {}
  void write(const log::Header& header) override {
    facts_.header = header;
    sum_.emplace(header);
    if (columns_ > 0) preview_.emplace(header, columns_);
  }
  void write(const log::Event& event) override {
    sum_->add(event);
    if (preview_) preview_->add(event);
  }
  Result<Published> finish() override { return Published{}; }

  LogFacts facts() const {
    LogFacts out = facts_;
    out.summary = sum_->finish();
    return out;
  }
  const std::optional<log::StrokePreview>& preview() const { return preview_; }

 private:
  int columns_;
  LogFacts facts_;
  std::optional<log::Summarizer> sum_;
  std::optional<log::StrokePreview> preview_;
};

/// Whether a file is one of another program. If not, it may still be a log. Errors: kBadInput for
/// what can be neither, those of the source and of the format.
Result<bool> describe_recording(const std::string& path, log::ByteSource& source,
                                int preview_columns, FileInfo& info) {
  const Result<std::string> bytes = sketch::read_recording(path, source);
  if (!bytes) return bytes.error();
  const sketch::Format* format = sketch::format_of(*bytes);
  if (format == nullptr) {
    if (may_be_a_log(*bytes)) return false;
    return Error{ErrorCode::kBadInput,
                 path + (are_of_an_output(*bytes)
                             ? ": a picture or a state dump, which can be read from a file only"
                             : ": neither a log nor a recording, PNG, EXR or state dump that can "
                               "be read")};
  }
  const Result<sketch::Sketch> drawing = format->read({path, *bytes}, {});
  if (!drawing) return drawing.error();
  FactsWriter writer(preview_columns);
  const Result<sketch::LogCounts> counts = write_log(*drawing, {}, {}, writer);
  if (!counts) return Error{counts.error().code, path + ": " + counts.error().message};
  const sketch::Report& report = counts->report;
  info.recording =
      FileInfo::Recording{std::string(format->name),
                          drawing->title,
                          report.file_strokes > 0 ? report.file_strokes : counts->strokes,
                          report.file_samples > 0 ? report.file_samples : counts->samples,
                          report,
                          writer.facts()};
  info.recording->log.summary.sha256 = sha256_hex(*bytes);
  info.preview = writer.preview();
  return true;
}

Result<log::StrokePreview> preview_log(const std::string& path, const log::ReaderOptions& reading,
                                       int columns) {
  Result<std::unique_ptr<log::Reader>> reader = log::Reader::open(path, reading);
  if (!reader) return reader.error();
  const log::Header& header = (*reader)->header();
  log::StrokePreview preview(header, columns);
  for (const log::PigmentSpec& spec : header.palette)
    if (const std::optional<log::Rgb> color = linear_of_hex(swatch_hex(spec)))
      preview.set_pigment(spec.name, *color);
  while (true) {
    const Result<std::optional<log::Event>> event = (*reader)->next();
    if (!event) return event.error();
    if (!*event) return preview;
    preview.add(**event);
  }
}

std::string counts_json(const std::map<std::string, std::int64_t>& counts) {
  ReportObject json;
  for (const auto& [name, count] : counts) json.add(name, count);
  return json.text();
}

template <typename Bins>
std::string bins_json(const Bins& bins) {
  return fmt::format("[{}]", fmt::join(bins, ","));
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

/// Left, top, right and bottom of all samples; empty if there is none.
std::string extent_json(const log::Bounds& bounds) {
  return bounds.empty() ? "[]"
                        : fmt::format("[{},{},{},{}]", bounds.min_x_m, bounds.min_y_m,
                                      bounds.max_x_m, bounds.max_y_m);
}

/// The colours that a recording has, as "#rrggbb".
std::vector<std::string> swatches_of(const log::Summary& sum) {
  std::vector<std::string> out;
  for (const log::Rgb& color : sum.colors) out.push_back(hex_of(color));
  return out;
}

void add_recording(const FileInfo::Recording& recording, ReportObject& json) {
  const log::Summary& sum = recording.log.summary;
  json.add("kind", "recording")
      .add("format", recording.format)
      .add("title", recording.title)
      .add("strokes", recording.strokes)
      .add("samples", recording.samples)
      .add("duration_s", sum.duration_s())
      .add("canvas_width_m", recording.log.header.canvas_width_m)
      .add("canvas_height_m", recording.log.header.canvas_height_m)
      .add_json("extent_m", extent_json(sum.bounds))
      .add_json("pressures", bins_json(sum.pressures))
      .add_json("tilts", bins_json(sum.tilts))
      .add("colors", static_cast<std::int64_t>(sum.colors.size()))
      .add_json("swatches", strings_json(swatches_of(sum)))
      .add_json("kept", strings_json(recording.report.kept))
      .add_json("guessed", strings_json(recording.report.guessed))
      .add_json("dropped", strings_json(recording.report.dropped))
      .add("sha256", sum.sha256);
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
      .add_json("extent_m", extent_json(log.summary.bounds))
      .add_json("pressures", bins_json(log.summary.pressures))
      .add_json("tilts", bins_json(log.summary.tilts))
      .add_json("pigments", strings_json(log.pigments))
      .add_json("swatches", strings_json(log.swatches))
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

/// Shares of the bins as bars of an eighth's steps: "▁▂▇█".
template <typename Bins>
std::string bars(const Bins& bins) {
  constexpr std::array<const char*, 9> kBars = {" ", "▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
  const std::int64_t most = *std::max_element(bins.begin(), bins.end());
  std::string out;
  for (const std::int64_t count : bins)
    out += kBars[most == 0 ? 0 : static_cast<std::size_t>((8 * count + most - 1) / most)];
  return out;
}

/// How the pen was held and where, one line each.
std::string strokes_text(const log::Summary& sum) {
  std::string text;
  if (!sum.bounds.empty())
    text += fmt::format("{:<12} {:.4g}..{:.4g} x {:.4g}..{:.4g} m\n", "extent", sum.bounds.min_x_m,
                        sum.bounds.max_x_m, sum.bounds.min_y_m, sum.bounds.max_y_m);
  if (sum.has_pressure) text += fmt::format("{:<12} 0 {} 1\n", "pressure", bars(sum.pressures));
  if (sum.has_tilt) text += fmt::format("{:<12} 0 {} 90 degrees\n", "tilt", bars(sum.tilts));
  return text;
}

/// "#rrggbb", on a terminal after a patch of that colour.
std::string swatch_text(const std::string& hex, bool on_terminal) {
  const std::optional<log::Rgb> color = linear_of_hex(hex);
  return on_terminal && color ? log::color_patch(*color) + " " + hex : hex;
}

std::string recording_text(const FileInfo::Recording& recording, bool on_terminal) {
  constexpr std::size_t kMostSwatches = 16;
  const log::Summary& sum = recording.log.summary;
  std::string text = fmt::format("recording, {}\n", recording.format);
  const auto line = [&](std::string_view key, const std::string& value) {
    if (!value.empty()) text += fmt::format("{:<12} {}\n", key, one_line(value));
  };
  line("title", recording.title);
  line("strokes", fmt::format("{}, {} samples", recording.strokes, recording.samples));
  line("duration", fmt::format("{:.1f} s", sum.duration_s()));
  line("canvas", fmt::format("{:.4g} x {:.4g} m", recording.log.header.canvas_width_m,
                             recording.log.header.canvas_height_m));
  text += strokes_text(sum);
  line("colours", fmt::format("{}", sum.colors.size()));
  const std::vector<std::string> swatches = swatches_of(sum);
  for (std::size_t i = 0; i < std::min(swatches.size(), kMostSwatches); ++i)
    text += fmt::format("  {}\n", swatch_text(swatches[i], on_terminal));
  if (swatches.size() > kMostSwatches)
    text += fmt::format("  and {} more\n", swatches.size() - kMostSwatches);
  line("kept", fmt::format("{}", fmt::join(recording.report.kept, ", ")));
  line("guessed", fmt::format("{}", fmt::join(recording.report.guessed, ", ")));
  line("dropped", fmt::format("{}", fmt::join(recording.report.dropped, ", ")));
  line("sha256", sum.sha256);
  return text;
}

std::string log_text(const LogFacts& log, bool on_terminal) {
  const log::Header& h = log.header;
  std::string text = fmt::format("action log, version {}\n", h.version);
  const auto line = [&](std::string_view key, const std::string& value) {
    if (!value.empty()) text += fmt::format("{:<12} {}\n", key, one_line(value));
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
  text += strokes_text(log.summary);
  line("pigments", fmt::format("{}", log.pigments.size()));
  for (std::size_t i = 0; i < log.pigments.size(); ++i) {
    const std::string swatch = swatch_text(log.swatches[i], on_terminal);
    text += log.pigments[i] == log.swatches[i]
                ? fmt::format("  {}\n", swatch)
                : fmt::format("  {:<24} {}\n", one_line(log.pigments[i]), swatch);
  }
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
  if (!output.profile.empty()) text += fmt::format("colours: {}\n", one_line(output.profile));
  for (const auto& [key, value] : output.provenance) {
    text += fmt::format("{:<24} {}\n", one_line(key), one_line(value));
  }
  return text;
}
}  // namespace

Result<FileInfo> file_info(const std::string& path, const log::ReaderOptions& reading,
                           int preview_columns) {
  FileInfo info;
  info.file = path;
  std::error_code problem;
  const bool is_file = path != "-" && std::filesystem::is_regular_file(path, problem);
  if (is_file && starts_like_an_output(path)) {
    Result<FileDescription> output = describe_file(path);
    if (!output) return output.error();
    info.output = std::move(*output);
    return info;
  }
  Result<std::unique_ptr<log::ByteSource>> source = log::ByteSource::open(path, reading);
  if (!source) return source.error();
  const Result<bool> is_log = log::starts_like_a_log(**source);
  if (!is_log) return is_log.error();
  if (!*is_log) {
    const Result<bool> known =
        describe_recording(shown_name(path), **source, preview_columns, info);
    if (!known) return known.error();
    if (*known) return info;
    if (const Result<void> back = (*source)->rewind(); !back) return back.error();
  }
  const Result<std::unique_ptr<log::Reader>> reader =
      log::Reader::open(path, std::move(*source), reading);
  if (!reader) return reader.error();
  Result<LogFacts> log = validate_log(path, **reader, reading);
  if (!log) return log.error();
  info.log = std::move(*log);
  if (!is_file || preview_columns == 0) return info;
  Result<log::StrokePreview> preview = preview_log(path, reading, preview_columns);
  if (!preview) return preview.error();
  info.preview = std::move(*preview);
  return info;
}

std::string info_json(const FileInfo& info) {
  ReportObject json;
  json.add("file", info.file);
  if (info.log) add_log(*info.log, json);
  if (info.recording) add_recording(*info.recording, json);
  if (info.output) add_output(*info.output, json);
  return json.text();
}

std::string info_text(const FileInfo& info) {
  if (info.output) return output_text(*info.output);
  const bool on_terminal = info.preview.has_value();
  const std::string text =
      info.log ? log_text(*info.log, on_terminal) : recording_text(*info.recording, on_terminal);
  return text + (info.preview ? info.preview->text() : "");
}

}  // namespace pentimento
