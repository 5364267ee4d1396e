#include <array>

#include "core/shading/gl/context.h"
#include "core/shading/gl/library.h"

namespace pentimento {
namespace {

// The library's interface, written out: distributions that dropped it have no header for it either.
using Context = struct OsmesaOpaque*;
using CreateContext = Context (*)(const int*, Context);
using DestroyContext = void (*)(Context);
using MakeCurrent = unsigned char (*)(Context, void*, unsigned, int, int);
using GetProcAddress = GlContext::Function (*)(const char*);
constexpr unsigned kUnsignedByte = 0x1401;
constexpr int kFormat = 0x22, kRgba = 0x1908, kProfile = 0x33, kCoreProfile = 0x34;
constexpr int kMajorVersion = 0x36, kMinorVersion = 0x37;

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
    if (context_ != nullptr && check_mesa_threads().ok()) destroy_(context_);
  }

  Result<void> make_current() override {
    if (Result<void> threads = check_mesa_threads(); !threads) return threads;
    // OSMesa wants a buffer for its window; pictures go to framebuffer objects.
    if (make_current_(context_, window_.data(), kUnsignedByte, kWindow, kWindow) != 0) {
      return {};
    }
    return Error{ErrorCode::kIo, "OSMesa: the context cannot be made current"};
  }
  void release() override { make_current_(nullptr, nullptr, kUnsignedByte, 0, 0); }
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
    constexpr int kAttributes[] = {kFormat,       kRgba, kProfile, kCoreProfile, kMajorVersion, 3,
                                   kMinorVersion, 3,     0};
    context_ = create_(kAttributes, nullptr);
    return context_ != nullptr;
  }

  CreateContext create_;
  DestroyContext destroy_;
  MakeCurrent make_current_;
  GetProcAddress get_;
  Context context_ = nullptr;
  std::array<unsigned char, 4 * kWindow * kWindow> window_{};
};

}  // namespace

Result<std::unique_ptr<GlContext>> open_osmesa_context() {
  return OsmesaContext::open();
}

}  // namespace pentimento
