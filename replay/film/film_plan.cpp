#include "replay/film/film_plan.h"

#include <algorithm>

#include "formats/video/video_writer.h"
#include "replay/film/film_planner.h"
#include "replay/output/frame_name.h"

namespace pentimento {

namespace {
bool has_video(const RenderJob& job) {
  return std::any_of(job.picture.outputs.begin(), job.picture.outputs.end(), is_video_name);
}

bool is_frame(const std::string& pattern) {
  return is_video_name(pattern) || pattern.find('%') != std::string::npos;
}

Result<void> check(const RenderJob& job) {
  const auto usage = [](const char* what) { return Error{ErrorCode::kUsage, what}; };
  if (!job.stops.empty()) return usage("--at: a film has frames of its own");
  if (job.settle_s) return usage("--settle does not go with a film");
  if (job.film.frames && job.film.length_s)
    return usage("--frames and --length both say how long the film is");
  if (std::none_of(job.picture.outputs.begin(), job.picture.outputs.end(), is_frame))
    return usage(
        "--frames and --length need an -o FILE.mp4, FILE.mkv or FILE.avi, or a name with %d");
  return {};
}

/// The names of frame `frame`: films and numbered pictures, and at the last one everything.
Result<std::vector<std::string>> names_of(const std::vector<std::string>& patterns, int frame,
                                          bool last) {
  std::vector<std::string> names;
  for (const std::string& pattern : patterns) {
    if (is_video_name(pattern) || (last && !is_frame(pattern))) {
      names.push_back(pattern);
    } else if (is_frame(pattern)) {
      Result<std::string> name = frame_name(pattern, frame);
      if (!name) return name.error();
      names.push_back(std::move(*name));
    }
  }
  return names;
}
}  // namespace

bool makes_film(const RenderJob& job) {
  return job.film.any() || has_video(job);
}

Result<FilmPlan> plan_film(const RenderJob& job, log::Reader& reader, bool stepped,
                           std::int64_t steps, const Control& control) {
  if (Result<void> fits = check(job); !fits) return fits.error();
  FilmPlanner planner(reader.header().steps_per_second, stepped);
  while (true) {
    if (Result<void> go = control.go_on(); !go) return go.error();
    Result<std::optional<log::Event>> event = reader.next();
    if (!event) return event.error();
    if (!*event) break;
    planner.add(**event);
  }
  if (Result<void> back = reader.rewind(); !back) return back.error();
  FilmPlan plan;
  plan.steps = planner.frames(job.film, steps);
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    Result<std::vector<std::string>> names =
        names_of(job.picture.outputs, static_cast<int>(i), i + 1 == plan.steps.size());
    if (!names) return names.error();
    Result<std::vector<std::vector<PlannedOutput>>> files = plan_outputs(*names, {});
    if (!files) return files.error();
    plan.files.push_back(std::move(files->front()));
  }
  return plan;
}

}  // namespace pentimento
