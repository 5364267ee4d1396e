#include "replay/commands/convert.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <vector>

#include "formats/import/recording_file.h"
#include "formats/io/sha256.h"
#include "formats/io/utf8.h"
#include "formats/log/edit/editing_writer.h"
#include "formats/log/edit/origin.h"
#include "formats/log/json/nearest_name.h"
#include "formats/log/reader.h"
#include "formats/log/stream/log_start.h"
#include "replay/job/report_object.h"
#include "replay/output/output_claim.h"

namespace pentimento {

namespace {
constexpr std::string_view kLogName = "log";

std::vector<std::string_view> format_names() {
  std::vector<std::string_view> names = {kLogName};
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

std::int64_t whole_microseconds(double seconds) {
  return std::llround(seconds * 1e6);
}

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

/// Steps, undo and redo act on what was done last, by whichever hand.
Result<void> check_mergeable(const std::string& file, const log::Event& event) {
  const log::Action& action = event.action;
  const bool undoes =
      std::holds_alternative<log::Undo>(action) || std::holds_alternative<log::Redo>(action);
  if (!undoes && !std::holds_alternative<log::Step>(action)) return {};
  return Error{ErrorCode::kBadInput, fmt::format("{}: a log with {} cannot be merged with another",
                                                 file, undoes ? "`undo` or `redo`" : "`step`")};
}

/// Reads the other log once to find what is wrong with it, and again while it is merged.
Result<log::OtherLog> open_merged(const std::string& file, const log::ReaderOptions& options) {
  Result<std::unique_ptr<log::Reader>> opened = log::Reader::open(file, options);
  if (!opened) return opened.error();
  const std::shared_ptr<log::Reader> reader = std::move(*opened);
  while (true) {
    const Result<std::optional<log::Event>> event = reader->next();
    if (!event) return event.error();
    if (!*event) break;
    if (const Result<void> good = check_mergeable(file, **event); !good) return good.error();
  }
  if (const Result<void> back = reader->rewind(); !back) return back.error();
  log::OtherLog out;
  out.header = reader->header();
  out.file = file_name(file);
  out.sha256 = reader->sha256();
  out.next = [reader]() -> std::optional<log::Event> {
    const Result<std::optional<log::Event>> event = reader->next();
    return event ? *event : std::nullopt;
  };
  return out;
}

Result<log::Edits> make_edits(const LogEdits& from, const log::ReaderOptions& reading) {
  log::Edits out;
  if (!from.merged_log.empty()) {
    Result<log::OtherLog> merged = open_merged(from.merged_log, reading);
    if (!merged) return merged.error();
    out.merged = std::move(*merged);
  }
  if (!from.gravity_file.empty()) {
    const Result<std::string> bytes = sketch::read_recording(from.gravity_file);
    if (!bytes) return bytes.error();
    Result<sketch::GravityRecording> gravity =
        sketch::read_gravity({from.gravity_file, *bytes}, from.gravity);
    if (!gravity) return gravity.error();
    out.gravity = std::move(gravity->readings);
    out.gravity_file = file_name(from.gravity_file);
    out.gravity_sha256 = sha256_hex(*bytes);
  }
  if (from.trim_s)
    out.trim_us = {whole_microseconds(from.trim_s->first), whole_microseconds(from.trim_s->second)};
  if (from.longest_idle_s) out.longest_idle_us = whole_microseconds(*from.longest_idle_s);
  out.speed = from.speed;
  out.resample_hz = from.resample_hz;
  out.canvas_m = from.canvas_m;
  out.size_factor = from.size_factor;
  if (from.spline_error_m) {
    out.spline.emplace();
    out.spline->place_m = *from.spline_error_m;
  }
  return out;
}

/// Writes nothing more once the job is told to stop, and leaves no file then.
class StoppableWriter : public log::Writer {
 public:
  StoppableWriter(Control control, std::unique_ptr<log::Writer> inner)
      : control_(std::move(control)), inner_(std::move(inner)) {}
  void write(const log::Header& header) override { inner_->write(header); }
  void write(const log::Event& event) override {
    if (control_.go_on()) inner_->write(event);
  }
  Result<Published> finish() override {
    if (Result<void> stopped = control_.go_on(); !stopped) return stopped.error();
    return inner_->finish();
  }

 private:
  Control control_;
  std::unique_ptr<log::Writer> inner_;
};

Result<std::unique_ptr<log::EditingWriter>> open_output(const ConvertJob& job) {
  Result<log::Edits> edits = make_edits(job.edits, job.log_reading);
  if (!edits) return edits.error();
  Control control = job.control ? job.control() : Control();
  Result<std::unique_ptr<log::Writer>> file =
      log::Writer::create(job.output, log::compression_of(job.output), job.no_clobber);
  if (!file) return file.error();
  return std::make_unique<log::EditingWriter>(
      std::move(*edits), std::make_unique<StoppableWriter>(std::move(control), std::move(*file)));
}

bool undoes(const sketch::Sketch& drawing) {
  return std::any_of(drawing.items.begin(), drawing.items.end(), [](const sketch::Item& item) {
    const auto* action = std::get_if<sketch::SketchAction>(&item);
    return action != nullptr &&
           (*action == sketch::SketchAction::kUndo || *action == sketch::SketchAction::kRedo);
  });
}

Result<void> convert_recording(const ConvertJob& job, ConvertFacts& facts,
                               std::unique_ptr<log::EditingWriter>& writer) {
  const Result<std::string> bytes = sketch::read_recording(job.input);
  if (!bytes) return bytes.error();
  const Result<const sketch::Format*> format = choose_format(job, *bytes);
  if (!format) return format.error();
  const Result<sketch::Sketch> drawing = (*format)->read({job.input, *bytes}, job.reading);
  if (!drawing) return drawing.error();
  if (!job.edits.merged_log.empty() && undoes(*drawing))
    return Error{ErrorCode::kBadInput,
                 job.input + ": a recording with `undo` or `redo` cannot be merged with another"};
  Result<std::unique_ptr<log::EditingWriter>> output = open_output(job);
  if (!output) return output.error();
  writer = std::move(*output);
  facts.format = (*format)->name;
  const sketch::SketchOrigin origin = {facts.format, file_name(job.input), sha256_hex(*bytes)};
  const Result<sketch::LogCounts> counts = write_log(*drawing, origin, job.writing, *writer);
  if (!counts) return Error{counts.error().code, job.input + ": " + counts.error().message};
  const sketch::Report& report = counts->report;
  facts.strokes = report.file_strokes > 0 ? report.file_strokes : counts->strokes;
  facts.samples = report.file_samples > 0 ? report.file_samples : counts->samples;
  facts.canvas_width_m = counts->canvas_width_m;
  facts.canvas_height_m = counts->canvas_height_m;
  facts.report = report;
  return {};
}

Result<void> convert_log(const ConvertJob& job, ConvertFacts& facts,
                         std::unique_ptr<log::EditingWriter>& writer) {
  log::ReaderOptions reading = job.log_reading;
  if (job.control) reading.cancelled = job.control().cancelled;
  Result<std::unique_ptr<log::Reader>> reader = log::Reader::open(job.input, reading);
  if (!reader) return reader.error();
  // The first pass finds what is wrong before anything is written, and the hash.
  bool names_files = false;
  while (true) {
    const Result<std::optional<log::Event>> event = (*reader)->next();
    if (!event) return event.error();
    if (!*event) break;
    const log::Action& action = (*event)->action;
    if (!job.edits.merged_log.empty())
      if (const Result<void> good = check_mergeable(job.input, **event); !good) return good;
    names_files |=
        std::holds_alternative<log::Load>(action) || std::holds_alternative<log::Camera>(action);
    const auto* touch = std::get_if<log::Touch>(&action);
    if (touch == nullptr) continue;
    facts.strokes += touch->phase == log::TouchPhase::kDown ? 1 : 0;
    facts.samples +=
        touch->phase == log::TouchPhase::kDown || touch->phase == log::TouchPhase::kMove ? 1 : 0;
  }
  Result<std::unique_ptr<log::EditingWriter>> output = open_output(job);
  if (!output) return output.error();
  writer = std::move(*output);
  log::Header header = (*reader)->header();
  facts.format = kLogName;
  facts.canvas_width_m = job.edits.canvas_m ? job.edits.canvas_m->first : header.canvas_width_m;
  facts.canvas_height_m = job.edits.canvas_m ? job.edits.canvas_m->second : header.canvas_height_m;
  log::name_origin(header, "x-edited", file_name(job.input), (*reader)->sha256());
  writer->write(header);
  if (auto back = (*reader)->rewind(); !back) return back;
  while (true) {
    const Result<std::optional<log::Event>> event = (*reader)->next();
    if (!event) return event.error();
    if (!*event) break;
    writer->write(**event);
  }
  facts.report.guessed = (*reader)->repaired();
  if (names_files) facts.report.kept = {"names of files, which must lie beside the new log"};
  return {};
}

std::string list_json(const std::vector<std::string>& texts) {
  std::vector<std::string> items;
  for (const std::string& text : texts) items.push_back(json_string(text));
  return json_array(items);
}

std::string list_text(const char* what, const std::vector<std::string>& texts) {
  return texts.empty()
             ? ""
             : fmt::format("{}: {}\n", what, one_line(fmt::format("{}", fmt::join(texts, ", "))));
}
}  // namespace

Result<ConvertFacts> convert(const ConvertJob& job) {
  ConvertFacts facts;
  facts.input = job.input;
  const std::vector<InputFile> inputs = {{job.input, "the recording"},
                                         {job.edits.merged_log, "the log of --merge"},
                                         {job.edits.gravity_file, "the file of --gravity"}};
  const Result<OutputClaim> claim = OutputClaim::take({job.output}, {job.output}, inputs);
  if (!claim) return claim.error();
  std::unique_ptr<log::EditingWriter> writer;
  const bool from_log =
      job.format == kLogName || (job.format.empty() && log::starts_like_a_log(job.input));
  const Result<void> done =
      from_log ? convert_log(job, facts, writer) : convert_recording(job, facts, writer);
  if (!done) return done.error();
  Result<Published> log = writer->finish();
  if (!log) return log.error();
  facts.log = std::move(*log);
  facts.log_strokes = writer->strokes();
  facts.log_samples = writer->samples();
  facts.events = writer->events();
  facts.duration_s = static_cast<double>(writer->last_us()) / 1e6;
  return facts;
}

std::string convert_json(const ConvertFacts& facts) {
  return ReportObject()
      .add("input", facts.input)
      .add("format", facts.format)
      .add("log", facts.log.file)
      .add("log_sha256", facts.log.sha256)
      .add("strokes", facts.strokes)
      .add("samples", facts.samples)
      .add("log_strokes", facts.log_strokes)
      .add("log_samples", facts.log_samples)
      .add("events", facts.events)
      .add("duration_s", facts.duration_s)
      .add("canvas_width_m", facts.canvas_width_m)
      .add("canvas_height_m", facts.canvas_height_m)
      .add_json("kept", list_json(facts.report.kept))
      .add_json("guessed", list_json(facts.report.guessed))
      .add_json("dropped", list_json(facts.report.dropped))
      .text();
}

std::string convert_text(const ConvertFacts& facts) {
  return fmt::format("{}: {}, {} strokes, {} samples\n", facts.input, facts.format, facts.strokes,
                     facts.samples) +
         fmt::format("log: {} strokes, {} samples, {} events, {:.1f} s\n", facts.log_strokes,
                     facts.log_samples, facts.events, facts.duration_s) +
         list_text("kept", facts.report.kept) + list_text("guessed", facts.report.guessed) +
         list_text("dropped", facts.report.dropped);
}

}  // namespace pentimento
