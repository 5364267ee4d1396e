#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "core/shading/gl/context.h"
#include "core/shading/gl/library.h"

namespace pentimento {
namespace {

/// The few entry points of libEGL that open a context without a surface.
struct EglFunctions {
  PFNEGLGETPROCADDRESSPROC get;
  PFNEGLGETPLATFORMDISPLAYPROC get_display;
  PFNEGLINITIALIZEPROC initialize;
  PFNEGLBINDAPIPROC bind_api;
  PFNEGLCHOOSECONFIGPROC choose_config;
  PFNEGLCREATECONTEXTPROC create;
  PFNEGLDESTROYCONTEXTPROC destroy;
  PFNEGLMAKECURRENTPROC make_current;

  explicit EglFunctions(const SharedLibrary& l)
      : get(l.function<PFNEGLGETPROCADDRESSPROC>("eglGetProcAddress")),
        get_display(l.function<PFNEGLGETPLATFORMDISPLAYPROC>("eglGetPlatformDisplay")),
        initialize(l.function<PFNEGLINITIALIZEPROC>("eglInitialize")),
        bind_api(l.function<PFNEGLBINDAPIPROC>("eglBindAPI")),
        choose_config(l.function<PFNEGLCHOOSECONFIGPROC>("eglChooseConfig")),
        create(l.function<PFNEGLCREATECONTEXTPROC>("eglCreateContext")),
        destroy(l.function<PFNEGLDESTROYCONTEXTPROC>("eglDestroyContext")),
        make_current(l.function<PFNEGLMAKECURRENTPROC>("eglMakeCurrent")) {}
  bool complete() const {
    return get && get_display && initialize && bind_api && choose_config && create && destroy &&
           make_current;
  }
};

class EglContext : public GlContext {
 public:
  static Result<std::unique_ptr<GlContext>> open() {
    auto library = SharedLibrary::open({"libEGL.so.1", "libEGL.so"});
    if (!library) return Error{ErrorCode::kIo, "EGL: " + library.error().message};
    std::unique_ptr<EglContext> context(new EglContext(EglFunctions(*library)));
    if (!context->create()) {
      return Error{ErrorCode::kIo, "EGL: no OpenGL 3.3 core context without a surface"};
    }
    return std::unique_ptr<GlContext>(std::move(context));
  }
  ~EglContext() override {
    // The display stays: it is one per process, and other contexts may live on it.
    if (context_ != EGL_NO_CONTEXT && check_mesa_threads().ok()) egl_.destroy(display_, context_);
  }

  Result<void> make_current() override {
    if (Result<void> threads = check_mesa_threads(); !threads) return threads;
    egl_.bind_api(EGL_OPENGL_API);  // per thread
    if (egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE) {
      return {};
    }
    return Error{ErrorCode::kIo, "EGL: the context cannot be made current"};
  }
  void release() override {
    egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  Function function(const char* name) const override { return egl_.get(name); }
  std::string_view name() const override { return "EGL"; }

 private:
  explicit EglContext(const EglFunctions& egl) : egl_(egl) {}
  bool create() {
    if (!egl_.complete()) return false;
    display_ = egl_.get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY || egl_.initialize(display_, nullptr, nullptr) != EGL_TRUE ||
        egl_.bind_api(EGL_OPENGL_API) != EGL_TRUE) {
      return false;
    }
    constexpr EGLint kAnyOpenGl[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                     EGL_NONE};
    EGLConfig config = nullptr;
    EGLint found = 0;
    if (egl_.choose_config(display_, kAnyOpenGl, &config, 1, &found) != EGL_TRUE || found < 1) {
      return false;
    }
    constexpr EGLint kCore33[] = {EGL_CONTEXT_MAJOR_VERSION,
                                  3,
                                  EGL_CONTEXT_MINOR_VERSION,
                                  3,
                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                  EGL_NONE};
    context_ = egl_.create(display_, config, EGL_NO_CONTEXT, kCore33);
    return context_ != EGL_NO_CONTEXT;
  }

  EglFunctions egl_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

Result<std::unique_ptr<GlContext>> open_egl_context() {
  return EglContext::open();
}

}  // namespace pentimento
