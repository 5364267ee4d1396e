#include "replay/output/output_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <memory>
#include <utility>

#include "core/shading/guided_picture.h"
#include "formats/exr/exr_writer.h"
#include "formats/io/output_file.h"
#include "formats/png/png_writer.h"
#include "formats/video/video_writer.h"
#include "replay/output/aov_pictures.h"
#include "replay/output/debug_picture.h"
#include "replay/output/film_frames.h"
#include "replay/output/tone_sink.h"

namespace pentimento {

struct OutputSet::Pending {
  WrittenFile file;
  std::unique_ptr<PictureFile> picture;  // one of the two
  std::unique_ptr<OutputFile> state;
  bool for_display = false;
  std::vector<std::string> planes;  // of the strips; empty: all
  bool goes_on = false;             // a film: complete only when all frames are in it
  std::string temporary = {};       // where a complete picture is
  bool kept = false;
  std::unique_ptr<FilmFrames> frames = {};  // of a film that is kept
  std::size_t frames_done = 0;              // those of stops that are done

  Result<void> publish() {
    if (picture) return picture->publish();
    Result<Published> published = state->publish();
    if (!published) return published.error();
    file.sha256 = published->sha256;
    return {};
  }
};

namespace {
bool is_picture(const PlannedOutput& output) {
  return output.kind != OutputKind::kState;
}

bool dithers(const PictureChoice& choice) {
  return choice.dither && choice.bit_depth == 8;
}

/// A crop is dithered as the same part of the whole picture is.
ColorEncoding color_encoding(const PictureChoice& choice) {
  ColorEncoding encoding = {choice.profile, dithers(choice)};
  if (choice.crop) {
    encoding.left = (*choice.crop)[0];
    encoding.top = (*choice.crop)[1];
  }
  return encoding;
}

/// What an EXR tells as its density: what the options say, else that of a picture as large as the
/// canvas.
double density_dpi(const OutputSize& size, const CanvasGeometry& canvas) {
  constexpr double kMetresPerInch = 0.0254;
  return size.dpi > 0 ? size.dpi : size.width / canvas.width_m * kMetresPerInch;
}

/// Hands strips on and tells how far they are; stops when the job is cancelled.
class WatchedSink : public PictureSink {
 public:
  WatchedSink(PictureSink& sink, int rows, const Control& control)
      : sink_(sink), rows_(rows), control_(control) {}
  Result<void> write(const PictureStrip& strip) override {
    if (Result<void> go = control_.go_on(); !go) return go;
    control_.report({"shade", strip.y0 + strip.rows, rows_});
    return sink_.write(strip);
  }

 private:
  PictureSink& sink_;
  int rows_;
  const Control& control_;
};
}  // namespace

Result<OutputSize> written_size(const PictureChoice& picture, const OutputSize& whole) {
  if (!picture.crop) return whole;
  const auto [x, y, width, height] = *picture.crop;
  const bool inside = x >= 0 && y >= 0 && width > 0 && height > 0 &&
                      std::int64_t{x} + width <= whole.width &&
                      std::int64_t{y} + height <= whole.height;
  if (inside) return OutputSize{width, height, whole.dpi};
  return Error{ErrorCode::kUsage, fmt::format("--crop {},{},{},{} is not inside {} x {} pixels", x,
                                              y, width, height, whole.width, whole.height)};
}

OutputSet::OutputSet(const OutputSettings& settings, Stopwatch& watch)
    : settings_(settings), watch_(watch) {}
OutputSet::~OutputSet() = default;

Result<void> OutputSet::open_shader() {
  if (shader_) return {};
  Result<std::unique_ptr<Shader>> shader =
      Shader::open(settings_.picture.backend, settings_.threads);
  if (!shader) return shader.error();
  shader_ = std::move(*shader);
  return {};
}

/// A video goes on from frame to frame. Returns its index among the pending files.
Result<std::size_t> OutputSet::open_video(const std::string& path) {
  for (std::size_t i = 0; i < pending_.size(); ++i) {
    if (pending_[i].file.file == path) return i;
  }
  Result<Pending> video = make_video(path, pending_.size(), {});
  if (!video) return video.error();
  pending_.push_back(std::move(*video));
  return pending_.size() - 1;
}

/// A video that will be number `index` of the pending files, and begins with frames that were kept.
Result<OutputSet::Pending> OutputSet::make_video(const std::string& path, std::size_t index,
                                                 const std::vector<std::uint64_t>& kept) {
  const PictureChoice& choice = settings_.picture;
  const Result<OutputSize> size = written_size(choice, settings_.size);
  if (!size) return size.error();
  VideoOptions options = {size->width,       size->height,  choice.frames_per_second,
                          choice.no_clobber, choice.dither, settings_.threads};
  // The frames file is there only after the video: until then nothing is encoded.
  auto frames = std::make_shared<FilmFrames*>(nullptr);
  if (!settings_.keep.empty())
    options.frame_done = [frames](std::span<const std::uint8_t> rgb) { (*frames)->add(rgb); };
  Result<std::unique_ptr<VideoFile>> video = create_video(path, options);
  if (!video) return video.error();
  Pending pending = {{path, size->width, size->height, {}, {}}, {}, {}, true, {}};
  pending.goes_on = true;
  if (!settings_.keep.empty()) {
    const std::size_t frame_bytes =
        3 * static_cast<std::size_t>(size->width) * static_cast<std::size_t>(size->height);
    Result<std::unique_ptr<FilmFrames>> file = FilmFrames::go_on(
        kept_frames(settings_.keep, index), frame_bytes, kept,
        [&](std::span<const std::uint8_t> rgb) { return (*video)->add_frame(rgb); });
    if (!file) return file.error();
    pending.frames = std::move(*file);
    pending.frames_done = kept.size();
    *frames = pending.frames.get();
  }
  pending.picture = std::move(*video);
  return pending;
}

void OutputSet::stop_done() {
  done_ = pending_.size();
  for (Pending& pending : pending_)
    if (pending.frames) pending.frames_done = pending.frames->checksums().size();
}

Result<std::vector<KeptOutput>> OutputSet::keep(const std::string& folder) {
  std::vector<KeptOutput> outputs;
  for (std::size_t i = 0; i < done_; ++i) {
    Pending& pending = pending_[i];
    KeptOutput output{pending.file, {}};
    if (pending.frames) {
      if (Result<void> synced = pending.frames->sync(); !synced) return synced.error();
      const std::vector<std::uint64_t>& all = pending.frames->checksums();
      output.frames.emplace(all.begin(),
                            all.begin() + static_cast<std::ptrdiff_t>(pending.frames_done));
    } else {
      const bool dump = pending.state != nullptr;
      const std::string from = dump ? pending.state->whole().temporary : pending.temporary;
      if (dump) output.file.sha256 = pending.state->whole().sha256;
      if (!pending.kept) {
        Result<void> linked = checkpoint::link_or_copy(from, kept_file(folder, i));
        if (!linked) return linked.error();
      }
      pending.kept = true;
    }
    outputs.push_back(std::move(output));
  }
  return outputs;
}

Result<void> OutputSet::recall(const std::vector<KeptOutput>& outputs, const std::string& folder,
                               const std::vector<std::vector<PlannedOutput>>& planned) {
  pending_.clear();
  done_ = 0;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const WrittenFile& file = outputs[i].file;
    if (!is_planned(file.file, planned)) {
      return Error{
          ErrorCode::kBadInput,
          fmt::format("{}: a slot names {}, which is no output of this job", folder, file.file)};
    }
    if (outputs[i].frames) {
      Result<Pending> video = make_video(file.file, i, *outputs[i].frames);
      if (!video) return video.error();
      pending_.push_back(std::move(*video));
      continue;
    }
    Result<std::unique_ptr<OutputFile>> adopted =
        adopt_kept(kept_file(folder, i), file, settings_.picture.no_clobber);
    if (!adopted) return adopted.error();
    Pending pending = {file, {}, std::move(*adopted), false, {}};
    pending.kept = true;
    pending_.push_back(std::move(pending));
  }
  done_ = pending_.size();
  return {};
}

Result<void> OutputSet::create(const PlannedOutput& output, const Scene& scene,
                               const Origin& origin) {
  const PictureChoice& choice = settings_.picture;
  Result<OutputSize> size = written_size(choice, settings_.size);
  if (!size) return size.error();
  Provenance provenance = provenance_of(origin, settings_.size, output.pattern);
  if (choice.debug_view) {
    *size = debug_picture_size(*size);
    provenance.emplace_back("debug_view", debug_view_name(*choice.debug_view));
  } else {
    provenance.emplace_back("shader", shader_->description());
  }
  provenance.emplace_back("profile", profile_name(choice.profile));
  Result<std::unique_ptr<PictureFile>> file = [&] {
    if (output.kind == OutputKind::kPng) {
      provenance.emplace_back("dither", dithers(choice) ? "on" : "off");
      return create_png(output.path,
                        {size->width, size->height, choice.bit_depth, size->dpi, provenance,
                         settings_.threads, choice.no_clobber, color_encoding(choice)});
    }
    std::vector<std::string> channels = {"R", "G", "B"};
    const auto extra = aov_channels(choice.aovs, scene.basis);
    if (extra) channels.insert(channels.end(), extra->begin(), extra->end());
    return create_exr(output.path,
                      {size->width, size->height, choice.full_float,
                       density_dpi(settings_.size, scene.canvas.geometry()), channels, provenance,
                       settings_.threads, choice.no_clobber, choice.profile});
  }();
  if (!file) return file.error();
  return add_pending({{output.path, size->width, size->height, {}, {}},
                      std::move(*file),
                      {},
                      output.kind == OutputKind::kPng,
                      {}});
}

/// Two files must not have the same name, and none that of an input. The names of AOV pictures are
/// not known when outputs are planned, so the check is here.
Result<void> OutputSet::add_pending(Pending pending) {
  if (Result<void> stay = check_inputs_stay({pending.file.file}, settings_.inputs); !stay)
    return stay;
  for (const Pending& other : pending_) {
    if (other.file.file == pending.file.file && other.file.file != "-") {
      return Error{ErrorCode::kUsage, other.file.file + ": is written twice"};
    }
  }
  pending_.push_back(std::move(pending));
  return {};
}

/// Creates the AOVs of a PNG, each as a PNG beside it.
Result<void> OutputSet::create_aovs(const PlannedOutput& output, const Scene& scene,
                                    const Origin& origin) {
  const PictureChoice& choice = settings_.picture;
  const CanvasGeometry& grid = scene.canvas.geometry();
  const bool on_cells = settings_.size.width <= grid.width && settings_.size.height <= grid.height;
  Result<std::vector<AovPicture>> pictures =
      aov_pictures(choice.aovs, scene.canvas, scene.basis, !on_cells);
  if (!pictures) return pictures.error();
  const Result<OutputSize> size = written_size(choice, settings_.size);
  if (!size) return size.error();
  for (const AovPicture& aov : *pictures) {
    const std::string path = aov_path(output.path, aov.name);
    PngOptions options = {size->width, size->height, 16, size->dpi,
                          provenance_of(origin, settings_.size, output.pattern)};
    options.threads = settings_.threads;
    options.no_clobber = choice.no_clobber;
    options.color.profile = choice.profile;
    options.numbers = aov.scale;
    options.provenance.emplace_back("aov", aov.name);
    std::optional<WrittenScale> scale;
    if (aov.scale) {
      scale = {aov.scale->offset, aov.scale->per_code, aov.unit};
      options.provenance.emplace_back("aov.offset", fmt::format("{}", scale->offset));
      options.provenance.emplace_back("aov.per_code", fmt::format("{}", scale->per_code));
      options.provenance.emplace_back("aov.unit", scale->unit);
    }
    Result<std::unique_ptr<PictureFile>> file = create_png(path, options);
    if (!file) return file.error();
    Result<void> added = add_pending(
        {{path, size->width, size->height, {}, scale}, std::move(*file), {}, false, aov.planes});
    if (!added) return added;
  }
  return {};
}

Result<void> OutputSet::add_pictures(const std::vector<PlannedOutput>& outputs, const Scene& scene,
                                     const Origin& origin) {
  if (std::none_of(outputs.begin(), outputs.end(), is_picture)) return {};
  watch_.start("shade");
  const bool debug = settings_.picture.debug_view.has_value();
  if (!debug) {
    if (Result<void> opened = open_shader(); !opened) return opened;
  }
  const bool exr = std::any_of(outputs.begin(), outputs.end(), [](const PlannedOutput& output) {
    return output.kind == OutputKind::kExr;
  });
  std::vector<std::size_t> videos;
  for (const PlannedOutput& output : outputs) {
    if (output.kind != OutputKind::kVideo) continue;
    const Result<std::size_t> video = open_video(output.path);
    if (!video) return video.error();
    videos.push_back(*video);
  }
  const std::size_t first_file = pending_.size();
  for (const PlannedOutput& output : outputs) {
    if (!is_picture(output) || output.kind == OutputKind::kVideo) continue;
    if (Result<void> created = create(output, scene, origin); !created) return created;
    const bool beside = output.kind == OutputKind::kPng && !settings_.picture.aovs.empty() && !exr;
    if (!beside) continue;
    if (Result<void> created = create_aovs(output, scene, origin); !created) return created;
  }
  std::vector<std::size_t> shown = videos;
  for (std::size_t i = first_file; i < pending_.size(); ++i) shown.push_back(i);
  Result<void> shaded = debug ? paint_debug_view(scene, shown) : shade(scene, shown);
  if (!shaded) return shaded;
  watch_.start("encode");
  for (std::size_t i = first_file; i < pending_.size(); ++i) {
    Result<Published> complete = pending_[i].picture->complete();
    if (!complete) return complete.error();
    pending_[i].file.sha256 = complete->sha256;
    pending_[i].temporary = complete->temporary;
  }
  return {};
}

Result<void> OutputSet::shade(const Scene& scene, const std::vector<std::size_t>& shown) {
  const PictureChoice& choice = settings_.picture;
  ShadeRequest request;
  request.width = settings_.size.width;
  request.height = settings_.size.height;
  int rows = request.height;
  if (choice.crop) {
    request.crop_x = (*choice.crop)[0];
    request.crop_y = (*choice.crop)[1];
    request.crop_width = (*choice.crop)[2];
    request.crop_height = rows = (*choice.crop)[3];
  }
  request.tile = choice.tile;
  request.aovs = choice.aovs;
  std::deque<ToneSink> toned;  // their addresses stay
  std::deque<PlaneSink> chosen;
  std::vector<WatchedSink> watched;
  std::vector<PictureSink*> sinks;
  for (const std::size_t i : shown) {
    const Pending& pending = pending_[i];
    PictureSink* sink = pending.picture.get();
    if (!pending.planes.empty()) sink = &chosen.emplace_back(*sink, pending.planes);
    toned.emplace_back(*sink, pending.for_display ? scene.lighting.tone : ToneCurve::kNone);
    watched.emplace_back(toned.back(), rows, settings_.control);
  }
  for (WatchedSink& sink : watched) sinks.push_back(&sink);
  if (scene.guide == nullptr)
    return shader_->shade(scene.canvas, scene.basis, scene.model, scene.lighting, request, sinks);
  const Threads threads(settings_.threads);
  return shade_guided(*shader_, {*scene.guide, scene.canvas}, scene.basis, scene.model,
                      scene.lighting, request, threads, sinks);
}

Result<void> OutputSet::paint_debug_view(const Scene& scene,
                                         const std::vector<std::size_t>& shown) {
  const PictureChoice& choice = settings_.picture;
  const Result<OutputSize> part = written_size(choice, settings_.size);
  if (!part) return part.error();
  DebugFrame frame{settings_.size, 0, 0, part->width, part->height};
  if (choice.crop) {
    frame.left = (*choice.crop)[0];
    frame.top = (*choice.crop)[1];
  }
  std::vector<PictureSink*> sinks;
  for (const std::size_t i : shown) sinks.push_back(pending_[i].picture.get());
  const DebugColors colors(*choice.debug_view,
                           measure_debug_scale(*choice.debug_view, scene.canvas, scene.basis));
  return write_debug_picture(colors, scene.canvas, scene.basis, frame, sinks, settings_.control);
}

Result<void> OutputSet::add_states(const std::vector<PlannedOutput>& outputs, const StateDump& dump,
                                   const Origin& origin) {
  watch_.start("encode");
  for (const PlannedOutput& output : outputs) {
    if (is_picture(output)) continue;
    DumpOptions options;
    options.threads = settings_.threads;
    options.provenance = provenance_of(origin, settings_.size, output.pattern);
    options.no_clobber = settings_.picture.no_clobber;
    options.cancelled = settings_.control.cancelled;
    Result<std::unique_ptr<OutputFile>> file = complete_state(output.path, dump, options);
    if (!file) return file.error();
    const CanvasGeometry& grid = dump.fine ? dump.fine->geometry() : dump.state.geometry;
    Result<void> added = add_pending(
        {{output.path, grid.width, grid.height, {}, {}}, {}, std::move(*file), false, {}});
    if (!added) return added;
  }
  return {};
}

Result<std::vector<WrittenFile>> OutputSet::publish() {
  for (Pending& pending : pending_) {
    if (!pending.goes_on) continue;
    Result<Published> complete = pending.picture->complete();
    if (!complete) return complete.error();
    pending.file.sha256 = complete->sha256;
  }
  std::vector<WrittenFile> written;
  for (Pending& pending : pending_) {
    if (Result<void> published = pending.publish(); !published) return published.error();
    written.push_back(pending.file);
  }
  pending_.clear();
  return written;
}

}  // namespace pentimento
