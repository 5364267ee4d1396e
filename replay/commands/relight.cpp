#include "replay/commands/relight.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "core/base/float_environment.h"
#include "formats/hdf5/state_dump.h"
#include "formats/io/provenance.h"
#include "formats/log/tables/model_fields.h"
#include "formats/video/video_writer.h"
#include "replay/commands/exchange_pigments.h"
#include "replay/commands/light_path.h"
#include "replay/film/even_sides.h"
#include "replay/job/stopwatch.h"
#include "replay/output/effective.h"
#include "replay/output/frame_name.h"
#include "replay/output/output_claim.h"
#include "replay/output/output_plan.h"
#include "replay/output/output_set.h"
#include "replay/play/copies.h"
#include "replay/play/light_override.h"

namespace pentimento {

namespace {
Result<std::vector<PlannedOutput>> plan_pictures(const PictureChoice& picture) {
  Result<std::vector<std::vector<PlannedOutput>>> plan = plan_outputs(picture.outputs, {});
  if (!plan) return plan.error();
  for (const PlannedOutput& output : plan->front()) {
    if (output.kind == OutputKind::kState) {
      return Error{ErrorCode::kUsage, "-o " + output.path + ": relight writes pictures only"};
    }
  }
  return std::move(plan->front());
}

/// Applies other paints, another illuminant, another observer.
Result<void> look_otherwise(const RelightJob& job, StateDump& dump) {
  const bool spectral = dump.model.optics == OpticsKind::kSpectral;
  const std::pair<const char*, const std::optional<std::string>&> names[] = {
      {"illuminant", job.illuminant}, {"observer", job.observer}};
  for (const auto& [name, value] : names) {
    if (!value) continue;
    if (!spectral)
      return Error{ErrorCode::kUsage, std::string("--") + name +
                                          ": the dump's optics are rgb, which know no light's "
                                          "spectrum; record with \"optics\":\"spectral\""};
    if (Result<void> set = log::set_model_text(dump.model, name, *value); !set) return set;
  }
  if (job.palette.empty()) return {};
  Result<std::vector<PigmentExchange>> exchanges = parse_exchanges(job.palette);
  if (!exchanges) return exchanges.error();
  return exchange_pigments(*exchanges, dump);
}

/// One picture of the light's path; without a path there is one frame.
struct Frame {
  Lamp lamp;
  std::vector<PlannedOutput> outputs;
};

Result<std::vector<Frame>> plan_frames(const RelightJob& job, const Lamp& lamp) {
  if (job.light_path.empty()) {
    if (job.frames > 0) return Error{ErrorCode::kUsage, "--frames goes with --light-path"};
    Result<std::vector<PlannedOutput>> outputs = plan_pictures(job.picture);
    if (!outputs) return outputs.error();
    for (const PlannedOutput& output : *outputs) {
      if (output.kind == OutputKind::kVideo) {
        return Error{ErrorCode::kUsage, "-o " + output.path + ": a film needs --light-path"};
      }
    }
    return std::vector<Frame>{{lamp, std::move(*outputs)}};
  }
  Result<std::vector<std::array<float, 3>>> places = light_path(job.light_path, job.frames, lamp);
  if (!places) return places.error();
  std::vector<Frame> frames;
  for (const std::array<float, 3>& place : *places) {
    PictureChoice picture;
    for (const std::string& pattern : job.picture.outputs) {
      Result<std::string> name = is_video_name(pattern)
                                     ? Result<std::string>(pattern)
                                     : frame_name(pattern, static_cast<int>(frames.size()));
      if (!name) return name.error();
      picture.outputs.push_back(std::move(*name));
    }
    Result<std::vector<PlannedOutput>> outputs = plan_pictures(picture);
    if (!outputs) return outputs.error();
    Frame& frame = frames.emplace_back(Frame{lamp, std::move(*outputs)});
    (lamp.position_m ? *frame.lamp.position_m : frame.lamp.direction) = place;
  }
  return frames;
}

Origin origin_of(const StateDump& dump, const RelightJob& job,
                 const std::map<std::string, std::string>& files) {
  Origin origin;
  origin.files = files;
  origin.log_sha256 = dump.log_sha256;
  origin.state_sha256 = dump.state_sha256;
  origin.guide_sha256 = dump.guide_sha256;
  origin.detail = dump.detail;
  origin.other_painting = provenance_value(dump.provenance, "painting");
  origin.model = dump.model;
  origin.grid = dump.state.geometry;
  origin.steps_per_second = dump.steps_per_second;
  origin.step = dump.state.step;
  origin.time_s = dump.time_s;
  origin.lighting = clone_lighting(dump.lighting);
  origin.command = job.command;
  return origin;
}

/// As in a render; without any way given, a pixel for each cell of the dump's canvas.
Result<OutputSize> relit_size(SizeRequest request, const CanvasGeometry& guide,
                              const CanvasGeometry& canvas) {
  if (!request.width && !request.height && !request.scale && !request.print)
    request.width = canvas.width;
  return output_size(request, guide);
}
}  // namespace

Result<JobReport> relight(const RelightJob& job, const Control& control) {
  const PlainArithmetic plain;
  Stopwatch watch;
  watch.start("read");
  if (job.picture.debug_view && !job.light_path.empty()) {
    return Error{ErrorCode::kUsage, "--debug-view and --light-path: a debug view has no light"};
  }
  if (job.light.follow_gravity) {
    return Error{ErrorCode::kUsage, "--light gravity: a state dump does not know the gravity"};
  }
  Result<StateDump> dump = read_state(job.state, {job.threads, control.cancelled});
  if (!dump) return dump.error();
  Result<LightOverride> light = LightOverride::make(job.light);
  if (!light) return light.error();
  light->apply(dump->lighting);
  std::map<std::string, std::string> files;
  if (Result<void> added = add_file_of_option("--environment", job.light.environment, files);
      !added)
    return added.error();
  if (Result<void> seen = look_otherwise(job, *dump); !seen) return seen.error();
  const StateSource guide(dump->state);
  const CanvasSource& canvas = dump->fine ? *dump->fine : guide;
  Result<OutputSize> size = relit_size(job.size, dump->state.geometry, canvas.geometry());
  if (!size) return size.error();
  if (Result<void> even = check_even_sides(job.picture, *size, dump->state.geometry); !even)
    return even.error();

  const Threads threads(job.threads);
  const std::vector<InputFile> inputs = {{job.state, "the state"},
                                         {job.light.environment, "the picture of --environment"},
                                         {job.light_path, "the file of --light-path"}};
  const OutputSettings settings{job.picture, *size, threads.count(), control, inputs};
  OutputSet set(settings, watch);
  Result<std::vector<Frame>> frames = plan_frames(job, dump->lighting.lamps.front());
  if (!frames) return frames.error();
  std::vector<std::vector<PlannedOutput>> outputs;
  for (const Frame& frame : *frames) outputs.push_back(frame.outputs);
  const Result<OutputClaim> claim =
      OutputClaim::take(job.picture.outputs, paths_of(outputs), inputs);
  if (!claim) return claim.error();
  const Scene scene{canvas, dump->basis, dump->model, dump->lighting,
                    dump->fine ? &guide : nullptr};
  for (const Frame& frame : *frames) {
    dump->lighting.lamps.front() = frame.lamp;
    Result<void> added = set.add_pictures(frame.outputs, scene, origin_of(*dump, job, files));
    if (!added) return added.error();
  }
  watch.start("publish");
  Result<std::vector<WrittenFile>> written = set.publish();
  if (!written) return written.error();
  watch.stop();
  JobReport report;
  report.outputs = std::move(*written);
  report.threads = threads.count();
  report.state_sha256 = dump->state_sha256;
  report.guide_sha256 = dump->guide_sha256;
  report.detail = dump->detail;
  report.log_sha256 = dump->log_sha256;
  report.phases = watch.phases();
  report.wall_s = watch.total_s();
  report.peak_memory_bytes = peak_memory_bytes();
  return report;
}

}  // namespace pentimento
