// pentimento convert IN -o LOG: another program's recording becomes an action log.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstdio>
#include <map>

#include "cli/command.h"
#include "cli/range.h"
#include "replay/commands/convert.h"

namespace pentimento::cli {

namespace {
constexpr const char* kAbout =
    "Make an action log of what another program recorded. The content tells the format.\n\n"
    "Examples:\n"
    "  pentimento convert painting.tilt -o painting.jsonl.gz\n"
    "  pentimento convert strokes.csv -o strokes.jsonl --as csv --csv-time ms --csv-y-up\n"
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
  column("--csv-twist", csv.twist, "degrees");
  column("--csv-stroke", csv.stroke, "another value is another stroke");
  column("--csv-pen", csv.pen, "0 where the pen is up");
  column("--csv-width", csv.width, "of the line");
  column("--csv-color", csv.color, "#rrggbb");
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

int run_convert(const Arguments& arguments) {
  ConvertJob job;
  bool json = false, quiet = false;
  CLI::App app(kAbout, "pentimento convert");
  app.add_option("in", job.input, "a recording; `-` is standard input")->required();
  app.add_option("-o,--output", job.output,
                 "the log: .jsonl, .jsonl.gz or .jsonl.zst; `-` is standard output (-)");
  app.add_option("--as", job.format, "the format, if the content must not decide")
      ->type_name("FORMAT");
  app.add_option("--view", job.reading.view, "of 3-D sketches: camera, plane or front (camera)")
      ->transform(CLI::Transformer(kViews))
      ->type_name("VIEW");
  app.add_option("--size", job.writing.size_factor, "on the widths of all strokes (1)")
      ->check(in_range(1e-3, 1e3))
      ->type_name("F");
  app.add_option("--drop-idle", job.writing.longest_pause_s,
                 "pauses longer than this are cut to it (10)")
      ->check(in_range(0, 1e9))
      ->type_name("S");
  app.add_option("--cells", job.writing.cells, "of the grid's longer side (1024)")
      ->check(in_range(16, 16384))
      ->type_name("N");
  add_csv_options(app, job.reading.csv);
  app.add_flag("--json", json, "the report as one JSON object, on standard output");
  app.add_flag("--quiet", quiet, "no report");
  app.add_flag("--no-clobber", job.no_clobber, "refuse to overwrite");
  if (const std::optional<int> code = parse(app, arguments)) return *code;
  if (json && job.output == "-")
    return fail({ErrorCode::kUsage, "--json and the log cannot both go to standard output"});

  const Result<ConvertFacts> done = convert(job);
  if (!done) return fail(done.error());
  if (json) return print(convert_json(*done) + "\n");
  if (!quiet) std::fputs(convert_text(*done).c_str(), stderr);
  return 0;
}

}  // namespace pentimento::cli
