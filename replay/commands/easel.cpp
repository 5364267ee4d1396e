#include "replay/commands/easel.h"

#include <cmath>
#include <optional>
#include <utility>

#include "core/base/float_environment.h"
#include "core/brush/stroke_path.h"
#include "core/canvas/canvas_source.h"
#include "core/shading/shader.h"
#include "formats/color/row_encoder.h"
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
#include "replay/play/copies.h"
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

/// By sqrt: hypot() may differ in the last bit from that of another who writes the same log.
double distance_m(const StrokePoint& a, const StrokePoint& b) {
  const double x = b.x_m - a.x_m, y = b.y_m - a.y_m;
  return std::sqrt(x * x + y * y);
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
/// Keeps a picture as the codes that a PNG of 8 bits would have.
class BytesSink final : public PictureSink {
 public:
  explicit BytesSink(EaselPicture& picture) : picture_(picture), encoder_({}, 8) {
    picture_.rgb.resize(std::size_t{3} * static_cast<std::size_t>(picture_.width) *
                        static_cast<std::size_t>(picture_.height));
  }
  Result<void> write(const PictureStrip& strip) override {
    for (int y = 0; y < strip.rows; ++y) {
      std::uint8_t* out = picture_.rgb.data() + std::size_t{3} *
                                                    static_cast<std::size_t>(picture_.width) *
                                                    static_cast<std::size_t>(strip.y0 + y);
      const RgbRow row{strip.plane[0].row(y), strip.plane[1].row(y), strip.plane[2].row(y)};
      if (!encoder_.encode(row, picture_.width, strip.y0 + y, out))
        return Error{ErrorCode::kNonFinite, "the picture is not finite"};
    }
    return {};
  }

 private:
  EaselPicture& picture_;
  RowEncoder encoder_;
};
}  // namespace

struct Easel::Impl {
  /// What the header gives names to.
  struct Named {
    Named(BrushTable brush_table, Palette pigments)
        : brushes(std::move(brush_table)), palette(std::move(pigments)) {}
    BrushTable brushes;
    Palette palette;
  };

  Impl(const log::Header& header, int thread_count, BrushTable brush_table, Palette pigments,
       SimulationSetup setup)
      : threads(thread_count),
        named(std::make_shared<Named>(std::move(brush_table), std::move(pigments))),
        clock(header.steps_per_second),
        lighting(default_lighting()),
        own_simulation(std::make_unique<Simulation>(std::move(setup), threads)),
        simulation(*own_simulation) {
    develop(header.picture, lighting);
    simulation.set_gravity(core_gravity({}));
    hold(brushes.first(), {});
    simulation.set_color(0);
  }

  /// A fork.
  Impl(const Impl& other)
      : threads(other.threads.count()),
        named(other.named),
        clock(other.clock),
        lighting(clone_lighting(other.lighting)),
        own_simulation(other.simulation.fork(threads)),
        simulation(*own_simulation),
        settings(other.settings),
        spacing_frac(other.spacing_frac),
        now_us(other.now_us),
        strokes(other.strokes),
        problem(other.problem),
        shader(other.shader) {}
  Impl& operator=(const Impl&) = delete;

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
  Result<OutputSize> picture_size(int width) const;
  Result<void> open_shader();
  Result<void> shade(const OutputSize& size, PictureSink& sink);
  void fail(std::string message) {
    if (!problem) problem = Error{ErrorCode::kBadInput, std::move(message)};
  }

  const Threads threads;
  const std::shared_ptr<const Named> named;  // forks share it
  const BrushTable& brushes = named->brushes;
  const Palette& palette = named->palette;
  const StepClock clock;
  Lighting lighting;
  std::unique_ptr<Simulation> own_simulation;
  Simulation& simulation;
  BrushSettings settings;
  double spacing_frac = 0;
  std::int64_t now_us = 0;
  std::uint32_t strokes = 0;
  std::optional<Error> problem;
  std::shared_ptr<Shader> shader;  // forks share it: to open one takes longer than a small picture
};

/// Whole microseconds, as the times of a log.
std::vector<TouchSample> Easel::Impl::samples_of(const std::vector<StrokePoint>& points,
                                                 double speed_m_s) const {
  std::vector<TouchSample> samples;
  double length_m = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const StrokePoint& point = points[i];
    if (i > 0) length_m += distance_m(points[i - 1], point);
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

Result<std::unique_ptr<Easel>> Easel::open(const log::Header& header, int threads,
                                           std::shared_ptr<TipRack> tips) {
  const PlainArithmetic plain;
  LogFiles files("-", false);
  Result<BrushTable> brushes = BrushTable::make(header, files);
  if (!brushes) return brushes.error();
  Result<Palette> palette = Palette::make(header.palette, PaintMaker(header.model));
  if (!palette) return palette.error();
  Result<SimulationSetup> setup = setup_of(header, *palette, files);
  if (!setup) return setup.error();
  setup->tips = std::move(tips);
  return std::unique_ptr<Easel>(new Easel(std::make_unique<Impl>(
      header, threads, std::move(*brushes), std::move(*palette), std::move(*setup))));
}

void Easel::take_brush(const std::string& name, const BrushSettings& settings) {
  const PlainArithmetic plain;
  if (!impl_->brushes.has(name)) return impl_->fail("no brush is called \"" + name + "\"");
  impl_->hold(impl_->brushes.find(name), settings);
}

void Easel::take_color(const std::string& pigment) {
  const PlainArithmetic plain;
  if (!impl_->palette.has(pigment))
    return impl_->fail("no pigment of the palette is called \"" + pigment + "\"");
  impl_->simulation.set_color(impl_->palette.find(pigment));
}

void Easel::stroke(const std::vector<StrokePoint>& points, double speed_m_s) {
  const PlainArithmetic plain;
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
  const PlainArithmetic plain;
  PENTIMENTO_CHECK(seconds >= 0);
  impl_->now_us += microseconds(seconds);
  if (!impl_->problem) impl_->advance(impl_->now_us);
}

void Easel::step(int steps) {
  const PlainArithmetic plain;
  PENTIMENTO_CHECK(steps >= 0);
  Impl& in = *impl_;
  if (in.problem) return;
  // The time that they take, to the microsecond that is in the right step.
  const std::int64_t end = in.simulation.state().step + steps;
  in.now_us += microseconds(in.clock.seconds(steps));
  while (in.clock.step_of(in.now_us) < end) ++in.now_us;
  while (in.clock.step_of(in.now_us) > end) --in.now_us;
  in.advance(in.now_us);
}

void Easel::set_gravity(double x_m_s2, double y_m_s2, double z_m_s2) {
  const PlainArithmetic plain;
  impl_->simulation.set_gravity(core_gravity({x_m_s2, y_m_s2, z_m_s2}));
}

std::unique_ptr<Easel> Easel::fork() const {
  const PlainArithmetic plain;
  return std::unique_ptr<Easel>(new Easel(std::make_unique<Impl>(*impl_)));
}

const std::optional<Error>& Easel::problem() const {
  return impl_->problem;
}

double Easel::time_s() const {
  return static_cast<double>(impl_->now_us) / kMicroseconds;
}

void Easel::dry() {
  const PlainArithmetic plain;
  if (!impl_->problem) impl_->simulation.dry();
}

Result<OutputSize> Easel::Impl::picture_size(int width) const {
  return output_size({width > 0 ? std::optional(width) : std::nullopt, {}, {}, {}, 0},
                     simulation.state().geometry);
}

Result<void> Easel::Impl::shade(const OutputSize& size, PictureSink& sink) {
  ToneSink toned(sink, lighting.tone);
  ShadeRequest request;
  request.width = size.width;
  request.height = size.height;
  return shader->shade(StateSource(simulation.state()), simulation.basis(), simulation.model(),
                       lighting, request, {&toned});
}

Result<void> Easel::Impl::open_shader() {
  if (problem) return *problem;
  if (shader) return {};
  // Without a thread of its own Mesa also works in a process that is forked off.
  const int gl_threads = threads.count() > 1 ? threads.count() : 0;
  Result<std::unique_ptr<Shader>> opened = Shader::open(GlBackend::kAuto, gl_threads);
  if (!opened) return opened.error();
  shader = std::move(*opened);
  return {};
}

Result<Published> Easel::write_png(const std::string& path, int width) {
  const PlainArithmetic plain;
  Impl& in = *impl_;
  const Result<OutputSize> size = in.picture_size(width);
  if (!size) return size.error();
  if (Result<void> opened = in.open_shader(); !opened) return opened.error();
  PngOptions options;
  options.width = size->width;
  options.height = size->height;
  options.threads = in.threads.count();
  options.provenance = {{"software", software()},
                        {"state_sha256", state_sha256(in.simulation.state())},
                        {"shader", in.shader->description()}};
  Result<std::unique_ptr<PictureFile>> png = create_png(path, options);
  if (!png) return png.error();
  if (Result<void> shaded = in.shade(*size, **png); !shaded) return shaded.error();
  return (*png)->finish();
}

Result<EaselPicture> Easel::picture(int width) {
  const PlainArithmetic plain;
  Impl& in = *impl_;
  const Result<OutputSize> size = in.picture_size(width);
  if (!size) return size.error();
  if (Result<void> opened = in.open_shader(); !opened) return opened.error();
  EaselPicture picture{size->width, size->height, {}};
  BytesSink bytes(picture);
  if (Result<void> shaded = in.shade(*size, bytes); !shaded) return shaded.error();
  return picture;
}

Lighting& Easel::lighting() {
  return impl_->lighting;
}
Simulation& Easel::simulation() {
  return impl_->simulation;
}

}  // namespace pentimento
