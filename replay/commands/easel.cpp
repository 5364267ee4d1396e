#include "replay/commands/easel.h"

#include <cmath>
#include <optional>
#include <utility>

#include "core/brush/stroke_path.h"
#include "core/canvas/canvas_source.h"
#include "core/shading/shader.h"
#include "formats/hdf5/state_dump.h"
#include "formats/png/png_writer.h"
#include "replay/job/build_info.h"
#include "replay/job/output_size.h"
#include "replay/job/step_clock.h"
#include "replay/log/brushes.h"
#include "replay/log/log_files.h"
#include "replay/log/palette.h"
#include "replay/output/tone_sink.h"
#include "replay/paper/paper_relief.h"
#include "replay/play/hand.h"
#include "replay/play/lighting_track.h"
#include "replay/session/simulation_setup.h"

namespace pentimento {

namespace {
constexpr double kMicroseconds = 1e6;
constexpr int kTouch = 0;  // there is one hand

std::int64_t microseconds(double seconds) {
  return static_cast<std::int64_t>(seconds * kMicroseconds + 0.5);
}

Result<SimulationSetup> setup_of(const log::Header& header, const Palette& palette,
                                 LogFiles& files) {
  SimulationSetup setup = simulation_setup(header, header.model);
  setup.basis = make_channels(palette.pigments(), PaintMaker(header.model).wavelength_nm());
  Result<Field<float>> relief = paper_relief(header.paper, setup.geometry, files);
  if (!relief) return relief.error();
  setup.paper_m = std::move(*relief);
  return setup;
}
}  // namespace

struct Easel::Impl {
  Impl(const log::Header& header, int thread_count, BrushTable brush_table, Palette pigments,
       SimulationSetup setup)
      : threads(thread_count),
        brushes(std::move(brush_table)),
        palette(std::move(pigments)),
        clock(header.steps_per_second),
        lighting(default_lighting()),
        simulation(std::move(setup), threads) {
    develop(header.picture, lighting);
    simulation.set_gravity(core_gravity({}));
    hold(brushes.first(), {});
    simulation.set_color(0);
  }

  void hold(const BrushDefinition& brush, const BrushSettings& sliders) {
    settings = sliders;
    spacing_frac = static_cast<double>(brush.spacing > 0 ? brush.spacing : sliders.spacing);
    simulation.set_brush(brush);
    simulation.set_settings(sliders);
  }

  /// Does the steps before the one that `time_us` falls in.
  void advance(std::int64_t time_us) {
    const std::int64_t end = clock.step_of(time_us);
    const CanvasState& state = simulation.state();
    while (state.step < end) {
      if (!simulation.step() && state.step < end) simulation.skip(end - state.step);
    }
  }

  std::vector<TouchSample> samples_of(const std::vector<StrokePoint>& points,
                                      double speed_m_s) const;
  std::vector<Stamp> stamps_along(const std::vector<TouchSample>& samples) const;
  void fail(std::string message) {
    if (!problem) problem = Error{ErrorCode::kBadInput, std::move(message)};
  }

  const Threads threads;
  const BrushTable brushes;
  const Palette palette;
  const StepClock clock;
  Lighting lighting;
  Simulation simulation;
  BrushSettings settings;
  double spacing_frac = 0;
  std::int64_t now_us = 0;
  std::uint32_t strokes = 0;
  std::optional<Error> problem;
  std::unique_ptr<Shader> shader;
};

/// Whole microseconds, as the times of a log.
std::vector<TouchSample> Easel::Impl::samples_of(const std::vector<StrokePoint>& points,
                                                 double speed_m_s) const {
  std::vector<TouchSample> samples;
  double length_m = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const StrokePoint& point = points[i];
    if (i > 0) length_m += std::hypot(point.x_m - points[i - 1].x_m, point.y_m - points[i - 1].y_m);
    TouchSample sample;
    sample.x_m = point.x_m;
    sample.y_m = point.y_m;
    sample.time_s =
        static_cast<double>(now_us + microseconds(length_m / speed_m_s)) / kMicroseconds;
    sample.diameter_m = settings.size_m;
    sample.pressure = point.pressure;
    samples.push_back(sample);
  }
  return samples;
}

std::vector<Stamp> Easel::Impl::stamps_along(const std::vector<TouchSample>& samples) const {
  const CanvasGeometry& canvas = simulation.state().geometry;
  StrokePath path(spacing_frac, canvas.width_m, canvas.height_m);
  std::vector<Stamp> stamps;
  path.begin(samples.front());
  for (std::size_t i = 1; i < samples.size(); ++i) path.add(samples[i], stamps);
  path.finish(stamps);
  return stamps;
}

Easel::Easel(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Easel::~Easel() = default;

Result<std::unique_ptr<Easel>> Easel::open(const log::Header& header, int threads) {
  LogFiles files("-", false);
  Result<BrushTable> brushes = BrushTable::make(header, files);
  if (!brushes) return brushes.error();
  Result<Palette> palette = Palette::make(header.palette, PaintMaker(header.model));
  if (!palette) return palette.error();
  Result<SimulationSetup> setup = setup_of(header, *palette, files);
  if (!setup) return setup.error();
  return std::unique_ptr<Easel>(new Easel(std::make_unique<Impl>(
      header, threads, std::move(*brushes), std::move(*palette), std::move(*setup))));
}

void Easel::take_brush(const std::string& name, const BrushSettings& settings) {
  if (!impl_->brushes.has(name)) return impl_->fail("no brush is called \"" + name + "\"");
  impl_->hold(impl_->brushes.find(name), settings);
}

void Easel::take_color(const std::string& pigment) {
  if (!impl_->palette.has(pigment))
    return impl_->fail("no pigment of the palette is called \"" + pigment + "\"");
  impl_->simulation.set_color(impl_->palette.find(pigment));
}

void Easel::stroke(const std::vector<StrokePoint>& points, double speed_m_s) {
  PENTIMENTO_CHECK(speed_m_s > 0);
  Impl& in = *impl_;
  if (in.problem || points.empty()) return;
  const std::vector<TouchSample> samples = in.samples_of(points, speed_m_s);
  in.simulation.begin_stroke(kTouch, ++in.strokes);
  for (const Stamp& stamp : in.stamps_along(samples)) {
    in.advance(microseconds(stamp.time_s));
    in.simulation.stamp(kTouch, stamp);
  }
  in.now_us = microseconds(samples.back().time_s);
  in.advance(in.now_us);
  in.simulation.end_stroke(kTouch);
}

void Easel::wait(double seconds) {
  PENTIMENTO_CHECK(seconds >= 0);
  impl_->now_us += microseconds(seconds);
  if (!impl_->problem) impl_->advance(impl_->now_us);
}

void Easel::dry() {
  if (!impl_->problem) impl_->simulation.dry();
}

Result<Published> Easel::write_png(const std::string& path, int width) {
  Impl& in = *impl_;
  if (in.problem) return *in.problem;
  const CanvasState& state = in.simulation.state();
  const Result<OutputSize> size =
      output_size({width > 0 ? std::optional(width) : std::nullopt, {}, {}, {}, 0}, state.geometry);
  if (!size) return size.error();
  if (!in.shader) {
    Result<std::unique_ptr<Shader>> opened = Shader::open(GlBackend::kAuto, in.threads.count());
    if (!opened) return opened.error();
    in.shader = std::move(*opened);
  }
  PngOptions options;
  options.width = size->width;
  options.height = size->height;
  options.threads = in.threads.count();
  options.provenance = {{"software", software()},
                        {"state_sha256", state_sha256(state)},
                        {"shader", in.shader->description()}};
  Result<std::unique_ptr<PictureFile>> png = create_png(path, options);
  if (!png) return png.error();
  ToneSink toned(**png, in.lighting.tone);
  ShadeRequest request;
  request.width = size->width;
  request.height = size->height;
  const Result<void> shaded =
      in.shader->shade(StateSource(state), in.simulation.basis(), in.simulation.model(),
                       in.lighting, request, {&toned});
  if (!shaded) return shaded.error();
  return (*png)->finish();
}

Lighting& Easel::lighting() {
  return impl_->lighting;
}
Simulation& Easel::simulation() {
  return impl_->simulation;
}

}  // namespace pentimento
