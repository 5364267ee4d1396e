#pragma once
// An offscreen OpenGL 3.3 core context, wherever it comes from. The libraries are found at run
// time, so the program starts without them and says what is missing.

#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace pentimento {

class GlContext {
 public:
  using Function = void (*)();
  virtual ~GlContext() = default;
  /// Makes it the calling thread's context. One thread at a time.
  virtual Result<void> make_current() = 0;
  /// Leaves the calling thread without a context.
  virtual void release() = 0;
  /// Address of an OpenGL function, nullptr if there is none.
  virtual Function function(const char* name) const = 0;
  /// "OSMesa" or "EGL".
  virtual std::string_view name() const = 0;
};

/// Mesa's own offscreen library.
Result<std::unique_ptr<GlContext>> open_osmesa_context();
/// EGL without a surface: Mesa's software or a GPU's driver.
Result<std::unique_ptr<GlContext>> open_egl_context();

/// Lets Mesa keep compiled shaders in `folder`, which must be this user's own, and find them there:
/// most of the time that a small picture takes is compiling. Not for a process that makes pictures
/// after it was forked off: Mesa writes there from a thread of its own. Call it before the first
/// context opens. It sets environment variables.
void keep_compiled_shaders(const std::string& folder);

/// What Mesa reads from the environment when its first context opens: its threads (0 = it works in
/// the calling thread), that it keeps no compiled shaders on disk unless it was told to, and that
/// it prints no warnings. Later calls change nothing.
void prepare_mesa(int gl_threads);
/// An error in a process that was forked off one in which Mesa has threads: here it has none, and
/// would wait for them for ever.
Result<void> check_mesa_threads();

}  // namespace pentimento
