#include "core/shading/shader.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "core/shading/aov.h"
#include "core/shading/area_filter.h"
#include "core/shading/gl/context.h"
#include "core/shading/gl/functions.h"
#include "core/shading/gl_limits.h"
#include "core/shading/gloss_keeper.h"
#include "core/shading/picture_job.h"
#include "core/shading/sampling.h"
#include "core/shading/shade_program.h"

namespace pentimento {
namespace {

class GlShader : public Shader {
 public:
  static Result<std::unique_ptr<Shader>> open(std::unique_ptr<GlContext> context, int threads) {
    if (auto current = context->make_current(); !current) return current.error();
    auto functions = load_gl_functions(*context);
    if (!functions) return functions.error();
    std::unique_ptr<GlShader> shader(new GlShader(std::move(context), *functions, threads));
    shader->context_->release();
    return std::unique_ptr<Shader>(std::move(shader));
  }
  ~GlShader() override {
    if (context_->make_current()) programs_.clear();
    context_->release();
  }

  Result<void> shade(const CanvasSource& canvas, const ChannelBasis& basis, const Model& model,
                     const Lighting& lighting, const ShadeRequest& request,
                     const std::vector<PictureSink*>& sinks) override {
    if (auto valid = check(canvas, basis, request); !valid) return valid;
    auto planes = picture_planes(request.aovs, basis);
    if (!planes) return planes.error();
    if (auto current = context_->make_current(); !current) return current;
    const ShadeScene scene{canvas, basis, model, lighting};
    Result<void> done = reduces(canvas.geometry(), request)
                            ? run_reduced(scene, request, *planes, sinks)
                            : run(scene, request, *planes, sinks);
    if (done && !canvas.status()) done = canvas.status();
    context_->release();
    return done;
  }

  std::string description() const override { return description_; }

 private:
  GlShader(std::unique_ptr<GlContext> context, const GlFunctions& gl, int threads)
      : context_(std::move(context)), gl_(gl), threads_(std::max(threads, 1)) {
    const auto text = [&](GLenum name) {
      const GLubyte* s = gl_.GetString(name);
      return s == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(s));
    };
    description_ =
        std::string(context_->name()) + ", " + text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
  }

  static Result<void> check(const CanvasSource& canvas, const ChannelBasis& basis,
                            const ShadeRequest& r) {
    PENTIMENTO_CHECK(basis.channels() == canvas.channels());
    const bool spectral = !basis.wavelength_nm.empty();
    const int bands = spectral ? static_cast<int>(basis.wavelength_nm.size()) : 3;
    if (canvas.bands() != bands || basis.bands() != bands || bands < 3) {
      return Error{ErrorCode::kUsage,
                   "pictures are shaded from " +
                       std::string(spectral ? "the bands of the palette, " : "three bands, ") +
                       "this canvas has " + std::to_string(canvas.bands())};
    }
    if (!is_inside(r)) return Error{ErrorCode::kUsage, "the crop lies outside the picture"};
    return {};
  }

  static bool reduces(const CanvasGeometry& grid, const ShadeRequest& r) {
    return averages_cells(grid.width, grid.height, r.width, r.height);
  }

  Result<void> run_reduced(const ShadeScene& scene, const ShadeRequest& r,
                           const std::vector<PlaneSource>& planes,
                           const std::vector<PictureSink*>& sinks) {
    const CanvasGeometry& grid = scene.canvas.geometry();
    const AreaAxis x{grid.width, r.width}, y{grid.height, r.height};
    const int columns = r.crop_width > 0 ? r.crop_width : r.width;
    const int rows = r.crop_height > 0 ? r.crop_height : r.height;
    ShadeRequest cells = r;
    cells.width = grid.width;
    cells.height = grid.height;
    cells.crop_x = x.first_source(r.crop_x);
    cells.crop_y = y.first_source(r.crop_y);
    cells.crop_width = x.last_source(r.crop_x, columns) + 1 - cells.crop_x;
    cells.crop_height = y.last_source(r.crop_y, rows) + 1 - cells.crop_y;
    AreaFilter filter(x, r.crop_x, columns, y, r.crop_y, rows, sinks);
    return run(scene, cells, planes, {&filter});
  }

  Result<void> run(const ShadeScene& scene, const ShadeRequest& request,
                   const std::vector<PlaneSource>& planes, const std::vector<PictureSink*>& sinks) {
    const PictureLayout layout = lay_out(scene, request, planes);
    auto program = programs_.find(layout.variant);
    if (program == programs_.end()) {
      if (auto fits = check_gl_limits(gl_, layout.variant); !fits) return fits;
      auto linked = link_shade_program(gl_, layout.variant);
      if (!linked) return linked.error();
      program = programs_.emplace(layout.variant, std::move(*linked)).first;
    }
    const GlossTable* gloss = gloss_.table(scene.lighting, threads_);
    return shade_picture({gl_, program->second, gloss, threads_}, scene, layout, planes, sinks);
  }

  std::unique_ptr<GlContext> context_;
  GlFunctions gl_;
  std::string description_;
  std::map<ShadeVariant, GlProgram> programs_;
  Threads threads_;
  GlossKeeper gloss_;
};

}  // namespace

bool is_inside(const ShadeRequest& r) {
  return r.width > 0 && r.height > 0 && r.tile > 0 && r.crop_x >= 0 && r.crop_y >= 0 &&
         r.crop_width >= 0 && r.crop_height >= 0 &&
         r.crop_x <= r.width - std::max(r.crop_width, 1) &&
         r.crop_y <= r.height - std::max(r.crop_height, 1);
}

Result<std::unique_ptr<Shader>> Shader::open(GlBackend backend, int gl_threads) {
  prepare_mesa(gl_threads);
  if (Result<void> threads = check_mesa_threads(); !threads) return threads.error();
  std::string reasons;
  using Open = Result<std::unique_ptr<GlContext>> (*)();
  const std::pair<GlBackend, Open> backends[] = {{GlBackend::kOsmesa, open_osmesa_context},
                                                 {GlBackend::kEgl, open_egl_context}};
  for (const auto& [kind, open_context] : backends) {
    if (backend != GlBackend::kAuto && backend != kind) continue;
    auto context = open_context();
    auto shader = context ? GlShader::open(std::move(*context), gl_threads)
                          : Result<std::unique_ptr<Shader>>(context.error());
    if (shader) return shader;
    reasons += (reasons.empty() ? "" : "; ") + shader.error().message;
  }
  return Error{ErrorCode::kIo, "no offscreen OpenGL: " + reasons};
}

}  // namespace pentimento
