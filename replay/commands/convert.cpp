#include "replay/commands/convert.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "formats/io/read_file.h"
#include "formats/io/sha256.h"
#include "formats/log/json/nearest_name.h"
#include "replay/job/report_object.h"

namespace pentimento {

namespace {
constexpr std::int64_t kMostBytes = std::int64_t{1} << 30;

std::vector<std::string_view> format_names() {
  std::vector<std::string_view> names;
  for (const sketch::Format& format : sketch::formats()) names.push_back(format.name);
  return names;
}

Result<const sketch::Format*> choose_format(const ConvertJob& job, std::string_view bytes) {
  if (!job.format.empty()) {
    if (const sketch::Format* format = sketch::find_format(job.format)) return format;
    return Error{ErrorCode::kUsage, fmt::format("--as: no format is called '{}'{}", job.format,
                                                did_you_mean(job.format, format_names()))};
  }
  if (const sketch::Format* format = sketch::format_of(bytes)) return format;
  return Error{ErrorCode::kBadInput, fmt::format("{}: no format that can be read; --as takes {}",
                                                 job.input, fmt::join(format_names(), ", "))};
}

std::string list_json(const std::vector<std::string>& texts) {
  std::vector<std::string> items;
  for (const std::string& text : texts) items.push_back(json_string(text));
  return json_array(items);
}

std::string list_text(const char* what, const std::vector<std::string>& texts) {
  std::string text;
  for (const std::string& item : texts) text += (text.empty() ? "" : ", ") + item;
  return text.empty() ? "" : fmt::format("{}: {}\n", what, text);
}
}  // namespace

Result<ConvertFacts> convert(const ConvertJob& job) {
  const Result<std::string> bytes = read_file(job.input, kMostBytes);
  if (!bytes) return bytes.error();
  const Result<const sketch::Format*> format = choose_format(job, *bytes);
  if (!format) return format.error();
  const Result<sketch::Sketch> drawing = (*format)->read({job.input, *bytes}, job.reading);
  if (!drawing) return drawing.error();
  Result<std::unique_ptr<log::Writer>> writer =
      log::Writer::create(job.output, log::compression_of(job.output), job.no_clobber);
  if (!writer) return writer.error();
  const sketch::Origin origin = {std::string((*format)->name),
                                 std::filesystem::path(job.input).filename().string(),
                                 sha256_hex(*bytes)};
  Result<sketch::LogCounts> counts = write_log(*drawing, origin, job.writing, **writer);
  if (!counts) return Error{counts.error().code, job.input + ": " + counts.error().message};
  Result<Published> log = (*writer)->finish();
  if (!log) return log.error();
  return ConvertFacts{job.input, origin.format,   drawing->title,
                      *counts,   drawing->report, std::move(*log)};
}

std::string convert_json(const ConvertFacts& facts) {
  return ReportObject()
      .add("input", facts.input)
      .add("format", facts.format)
      .add("log", facts.log.file)
      .add("log_sha256", facts.log.sha256)
      .add("strokes", facts.counts.strokes)
      .add("samples", facts.counts.samples)
      .add("events", facts.counts.events)
      .add("duration_s", facts.counts.duration_s)
      .add("canvas_width_m", facts.counts.canvas_width_m)
      .add("canvas_height_m", facts.counts.canvas_height_m)
      .add_json("kept", list_json(facts.report.kept))
      .add_json("guessed", list_json(facts.report.guessed))
      .add_json("dropped", list_json(facts.report.dropped))
      .text();
}

std::string convert_text(const ConvertFacts& facts) {
  return fmt::format("{}: {}, {} strokes, {} samples, {:.1f} s\n", facts.input, facts.format,
                     facts.counts.strokes, facts.counts.samples, facts.counts.duration_s) +
         list_text("kept", facts.report.kept) + list_text("guessed", facts.report.guessed) +
         list_text("dropped", facts.report.dropped);
}

}  // namespace pentimento
