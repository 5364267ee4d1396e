// pentimento convert IN -o LOG: another program's recording becomes an action log, and a log
// another.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstdio>
#include <map>

#include "cli/command.h"
#include "cli/limit_options.h"
#include "cli/range.h"
#include "cli/signals.h"
#include "cli/values.h"
#include "formats/log/edit/spline_fit.h"
#include "replay/commands/convert.h"

namespace pentimento::cli {

namespace {
constexpr const char* kConvertAbout =
    "Make an action log of what another program recorded, or edit a log. The content tells the\n"
    "format.\n\n"
    "Examples:\n"
    "  pentimento convert painting.apa -o painting.jsonl.gz\n"
    "  pentimento convert strokes.csv -o strokes.jsonl --as csv --csv-time ms --csv-y-up\n"
    "  pentimento convert session.jsonl -o part.jsonl --trim 60..90 --speed 2\n"
    "  pentimento convert session.jsonl -o tilted.jsonl --gravity motion.csv\n"
    "  pentimento convert notes.rm | pentimento render - -o notes.png";

const std::map<std::string, sketch::View> kViews = {{"camera", sketch::View::kCamera},
                                                    {"plane", sketch::View::kPlane},
                                                    {"front", sketch::View::kFront}};

void add_csv_options(CLI::App& app, sketch::CsvColumns& csv) {
  const auto column = [&](const char* option, std::string& name, const char* what) {
    app.add_option(option, name, what)->type_name("COLUMN")->group("Tables (--as csv)");
  };
  column("--csv-x", csv.x, "name of a column, or its number from 1 (x)");
  column("--csv-y", csv.y, "(y)");
  column("--csv-time", csv.time, "");
  column("--csv-pressure", csv.pressure, "0..1");
  column("--csv-tilt-x", csv.tilt_x, "degrees");
  column("--csv-tilt-y", csv.tilt_y, "degrees");
  column("--csv-altitude", csv.altitude, "of the pen, radians; pi/2 is upright");
  column("--csv-azimuth", csv.azimuth, "radians, clockwise from the right");
  column("--csv-twist", csv.twist, "degrees");
  column("--csv-stroke", csv.stroke, "another value is another stroke");
  column("--csv-pen", csv.pen, "0 where the pen is up");
  column("--csv-width", csv.width, "of the line");
  column("--csv-color", csv.color, "#rrggbb");
  column("--csv-red", csv.red, "0..1, or 0..255 if any is over 1");
  column("--csv-green", csv.green, "");
  column("--csv-blue", csv.blue, "");
  app.add_option("--csv-unit", csv.metre_per_unit, "metres per unit; else the canvas is 1 m long")
      ->check(in_range(1e-9, 1e3))
      ->type_name("M")
      ->group("Tables (--as csv)");
  app.add_option("--csv-second", csv.second_per_unit, "seconds per unit of time (1)")
      ->check(in_range(1e-12, 1e6))
      ->type_name("S")
      ->group("Tables (--as csv)");
  app.add_flag("--csv-y-up", csv.y_up, "y grows upwards")->group("Tables (--as csv)");
}
}  // namespace

/// "A..B" in seconds; either may be missing.
Result<std::pair<double, double>> parse_part(const std::string& text) {
  const std::size_t dots = text.find("..");
  const Error bad = {ErrorCode::kUsage, "--trim takes FROM..TO in seconds, not '" + text + "'"};
  if (dots == std::string::npos) return bad;
  std::pair<double, double> out = {0, 9e9};
  const std::string from = text.substr(0, dots), to = text.substr(dots + 2);
  if (!from.empty()) {
    const Result<double> value = parse_number("--trim", from);
    if (!value) return value.error();
    out.first = *value;
  }
  if (!to.empty()) {
    const Result<double> value = parse_number("--trim", to);
    if (!value) return value.error();
    out.second = *value;
  }
  if (out.first < 0 || out.second < out.first) return bad;
  return out;
}

/// "WxH" in metres.
Result<std::pair<double, double>> parse_canvas(const std::string& text) {
  const std::size_t by = text.find('x');
  const Error bad = {ErrorCode::kUsage,
                     "--fit takes WIDTHxHEIGHT in metres, 0.001 to 100, not '" + text + "'"};
  if (by == std::string::npos) return bad;
  const Result<double> width = parse_number("--fit", text.substr(0, by));
  const Result<double> height = parse_number("--fit", text.substr(by + 1));
  if (!width || !height) return bad;
  for (const double side : {*width, *height})
    if (!(side >= 0.001 && side <= 100)) return bad;
  return std::pair(*width, *height);
}

/// The options of edits that need more than a number.
struct EditTexts {
  std::string trim, fit;
  bool as_spline = false;
  double spline_error_m = log::SplineTolerance().place_m;
};

void add_edit_options(CLI::App& app, LogEdits& edits, EditTexts& texts,
                      log::ReaderOptions& reading) {
  app.add_flag("--repair", reading.repair,
               "of a broken log: put right or drop what a log may not have");
  app.add_option("--trim", texts.trim, "only this part, in seconds; it becomes the beginning")
      ->type_name("FROM..TO");
  app.add_option("--speed", edits.speed, "so many times faster (1)")
      ->check(in_range(1e-3, 1e3))
      ->type_name("F");
  app.add_option("--drop-idle", edits.longest_idle_s,
                 "time in which nobody paints is cut to this (recordings: 10)")
      ->check(in_range(0, 1e9))
      ->type_name("S");
  app.add_option("--resample", edits.resample_hz, "samples of strokes a second")
      ->check(in_range(0.1, 1e5))
      ->type_name("HZ");
  app.add_option("--fit", texts.fit, "onto a canvas of this size, as large as it fits")
      ->type_name("WxH");
  app.add_option("--size", edits.size_factor, "on the sizes of brushes (1)")
      ->check(in_range(1e-3, 1e3))
      ->type_name("F");
  app.add_flag("--as-spline", texts.as_spline,
               "leave out samples that the curves of the strokes do not need");
  app.add_option("--spline-error", texts.spline_error_m,
                 "how far such a curve may be from a sample (0.0005)")
      ->check(in_range(1e-9, 1))
      ->type_name("M")
      ->needs("--as-spline");
  app.add_option("--merge", edits.merged_log, "another log of this canvas, as a second hand")
      ->type_name("LOG");
  app.add_option("--gravity", edits.gravity_file,
                 "readings of a sensor: CoreMotion, Android or devicemotion")
      ->type_name("FILE");
  app.add_option("--gravity-as", edits.gravity.as, "which sensor --gravity holds")
      ->check(CLI::IsMember({"coremotion", "android", "devicemotion", "devicemotion-ios"})
                  .description(""))
      ->type_name("coremotion|android|devicemotion|devicemotion-ios");
  app.add_option("--gravity-turn", edits.gravity.turn_deg,
                 "screen.orientation.angle while it was read (0)")
      ->check(CLI::IsMember({0, 90, 180, 270}).description(""))
      ->type_name("0|90|180|270");
}

int run_convert(const Arguments& arguments) {
  ConvertJob job;
  bool json = false, quiet = false;
  CLI::App app(kConvertAbout, "pentimento convert");
  app.add_option("in", job.input, "a recording; `-` is standard input")->required()->type_name("");
  app.add_option("-o,--output", job.output,
                 "the log: .jsonl, .jsonl.gz or .jsonl.zst; `-` is standard output (-)")
      ->type_name("FILE");
  app.add_option("--as", job.format, "the format, if the content must not decide")
      ->type_name("FORMAT");
  app.add_option("--view", job.reading.view, "of 3-D sketches (camera)")
      ->transform(CLI::Transformer(kViews))
      ->type_name("camera|plane|front");
  app.add_option("--cells", job.writing.cells, "of a recording's grid, its longer side (1024)")
      ->check(in_range(16, 16384))
      ->type_name("N");
  EditTexts texts;
  add_edit_options(app, job.edits, texts, job.log_reading);
  LimitOptions limits;
  limits.add_to(app, job.log_reading.limits);
  add_csv_options(app, job.reading.csv);
  app.add_flag("--json", json, "the report as one JSON object, on standard output");
  app.add_flag("--quiet", quiet, "no report");
  app.add_flag("--no-clobber", job.no_clobber, "refuse to overwrite");
  if (const std::optional<int> code = parse(app, arguments)) return *code;
  if (Result<void> limited = limits.complete(job.log_reading.limits); !limited)
    return fail(limited.error());
  if (json && job.output == "-")
    return fail({ErrorCode::kUsage, "--json and the log cannot both go to standard output"});

  if (!texts.trim.empty()) {
    const Result<std::pair<double, double>> part = parse_part(texts.trim);
    if (!part) return fail(part.error());
    job.edits.trim_s = *part;
  }
  if (!texts.fit.empty()) {
    const Result<std::pair<double, double>> canvas = parse_canvas(texts.fit);
    if (!canvas) return fail(canvas.error());
    job.edits.canvas_m = *canvas;
  }
  if (texts.as_spline) job.edits.spline_error_m = texts.spline_error_m;
  if (job.edits.longest_idle_s) job.writing.longest_pause_s = *job.edits.longest_idle_s;

  job.control = [] {
    Control control;
    control.cancelled = &watch_signals();
    return control;
  };
  const Result<ConvertFacts> done = convert(job);
  if (!done) return fail(done.error());
  if (json) return print(convert_json(*done) + "\n");
  if (!quiet) std::fputs(convert_text(*done).c_str(), stderr);
  return 0;
}

}  // namespace pentimento::cli
