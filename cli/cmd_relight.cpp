// pentimento relight STATE.h5 -o OUT: other light, no simulation.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>

#include "cli/command.h"
#include "cli/picture_options.h"
#include "cli/range.h"
#include "cli/shader_folder.h"
#include "cli/talk.h"
#include "formats/video/video_writer.h"
#include "replay/commands/relight.h"

namespace pentimento::cli {

namespace {
constexpr const char* kRelightAbout =
    "Shade a state dump again: other light, no simulation.\n\n"
    "Examples:\n"
    "  pentimento relight state.h5 -o evening.png --light=-1,0.2,0.3\n"
    "  pentimento relight state.h5 -o studio.exr --environment studio.hdr --exposure 0.5\n"
    "  pentimento relight state.h5 -o frame-%04d.png --light-path orbit --frames 48\n"
    "  pentimento relight state.h5 -o turn.mp4 --light-path orbit --frames 96";

struct RelightOptions {
  RelightJob job;
  PictureOptions picture;
  TalkOptions talk;
  std::optional<double> fps;
};

Result<void> complete(RelightOptions& o) {
  Result<PictureChoice> picture = o.picture.picture();
  if (!picture) return picture.error();
  o.job.picture = std::move(*picture);
  const std::vector<std::string>& outputs = o.job.picture.outputs;
  if (o.fps && std::none_of(outputs.begin(), outputs.end(), is_video_name)) {
    return Error{ErrorCode::kUsage, "--fps needs an -o FILE.avi, FILE.mkv or FILE.mp4"};
  }
  o.job.picture.frames_per_second = o.fps.value_or(o.job.picture.frames_per_second);
  Result<LightChoice> light = o.picture.lighting();
  if (!light) return light.error();
  o.job.light = std::move(*light);
  o.job.size = o.picture.size();
  o.job.threads = o.picture.threads;
  return check_outputs(o.job.picture.outputs, o.talk.json);
}
}  // namespace

int run_relight(const Arguments& arguments) {
  RelightOptions o;
  CLI::App app(kRelightAbout, "pentimento relight");
  app.add_option("state", o.job.state, "a state dump (.h5)")->required()->type_name("");
  app.add_option("--light-path", o.job.light_path,
                 "the lamp moves from frame to frame: orbit, or a file of points X Y Z")
      ->type_name("orbit|FILE");
  app.add_option("--frames", o.job.frames,
                 "of the light's path; the name needs %d or %04d, or is a film's: .avi .mkv .mp4")
      ->check(in_range(1, 100000))
      ->type_name("N");
  app.add_option("--fps", o.fps, "frames a second of a film (25)")
      ->check(in_range(1.0, 240.0))
      ->type_name("N");
  o.picture.add_to(app);
  app.add_option("--palette", o.job.palette,
                 "other paints: a file with a `palette`, or NAME=PAINT,... (library or #rrggbb)")
      ->type_name("FILE|NAME=PAINT,...");
  app.add_option("--illuminant", o.job.illuminant,
                 "on spectral paint: A, D50, D65, E, F2, F11, ...")
      ->type_name("NAME");
  app.add_option("--observer", o.job.observer, "of spectral paint")->type_name("1931|1964");
  o.talk.add_to(app);
  if (const std::optional<int> code = parse(app, arguments)) return *code;
  o.job.command = command_line("relight", arguments);
  if (Result<void> completed = complete(o); !completed) return fail(completed.error());
  Result<ProgressMode> mode = progress_mode(o.talk.progress, o.talk.quiet);
  if (!mode) return fail(mode.error());
  ProgressPrinter printer(*mode);
  use_shader_folder();
  Result<JobReport> done = relight(o.job, make_control(printer, o.talk));
  if (!done) return printer.fail(done.error());
  return report(*done, o.talk, printer);
}

}  // namespace pentimento::cli
