#include <GL/osmesa.h>

#include <array>

#include "core/shading/gl/context.h"
#include "core/shading/gl/library.h"

namespace pentimento {
namespace {

using CreateContext = OSMesaContext (*)(const int*, OSMesaContext);
using DestroyContext = void (*)(OSMesaContext);
using MakeCurrent = GLboolean (*)(OSMesaContext, void*, GLenum, GLsizei, GLsizei);
using GetProcAddress = OSMESAproc (*)(const char*);

class OsmesaContext : public GlContext {
 public:
  static Result<std::unique_ptr<GlContext>> open() {
    auto library = SharedLibrary::open({"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"});
    if (!library) return Error{ErrorCode::kIo, "OSMesa: " + library.error().message};
    std::unique_ptr<OsmesaContext> context(new OsmesaContext(*library));
    if (!context->create()) {
      return Error{ErrorCode::kIo, "OSMesa: no OpenGL 3.3 core context"};
    }
    return std::unique_ptr<GlContext>(std::move(context));
  }
  ~OsmesaContext() override {
    if (context_ != nullptr) destroy_(context_);
  }

  Result<void> make_current() override {
    // OSMesa wants a buffer for its window; pictures go to framebuffer objects.
    if (make_current_(context_, window_.data(), GL_UNSIGNED_BYTE, kWindow, kWindow) == GL_TRUE) {
      return {};
    }
    return Error{ErrorCode::kIo, "OSMesa: the context cannot be made current"};
  }
  void release() override { make_current_(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }
  Function function(const char* name) const override { return get_(name); }
  std::string_view name() const override { return "OSMesa"; }

 private:
  static constexpr int kWindow = 8;
  explicit OsmesaContext(const SharedLibrary& library)
      : create_(library.function<CreateContext>("OSMesaCreateContextAttribs")),
        destroy_(library.function<DestroyContext>("OSMesaDestroyContext")),
        make_current_(library.function<MakeCurrent>("OSMesaMakeCurrent")),
        get_(library.function<GetProcAddress>("OSMesaGetProcAddress")) {}
  bool create() {
    if (!create_ || !destroy_ || !make_current_ || !get_) return false;
    constexpr int kAttributes[] = {OSMESA_FORMAT,
                                   OSMESA_RGBA,
                                   OSMESA_PROFILE,
                                   OSMESA_CORE_PROFILE,
                                   OSMESA_CONTEXT_MAJOR_VERSION,
                                   3,
                                   OSMESA_CONTEXT_MINOR_VERSION,
                                   3,
                                   0};
    context_ = create_(kAttributes, nullptr);
    return context_ != nullptr;
  }

  CreateContext create_;
  DestroyContext destroy_;
  MakeCurrent make_current_;
  GetProcAddress get_;
  OSMesaContext context_ = nullptr;
  std::array<unsigned char, 4 * kWindow * kWindow> window_{};
};

}  // namespace

Result<std::unique_ptr<GlContext>> open_osmesa_context() {
  return OsmesaContext::open();
}

}  // namespace pentimento
