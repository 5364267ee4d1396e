#pragma once
// OpenGL objects that delete themselves. Their context must be current whenever they are used or
// destroyed, and the functions must outlive them.

#include <string>
#include <utility>
#include <vector>

#include "core/shading/gl/functions.h"

namespace pentimento {

/// How the values of a texture lie in memory; all are 32-bit floats.
enum class TexelFormat { kR, kRg, kRgb, kRgba };

/// A 2D texture, or a stack of them, whose texels are fetched by index (or filtered linearly and
/// clamped at the edge, if `filtered`).
class GlTexture {
 public:
  /// `layers` 0 = plain 2D. Contents are undefined until uploaded.
  GlTexture(const GlFunctions& gl, TexelFormat format, int width, int height, int layers = 0,
            bool filtered = false);
  ~GlTexture();
  GlTexture(GlTexture&& other) noexcept
      : gl_(other.gl_),
        format_(other.format_),
        target_(other.target_),
        id_(std::exchange(other.id_, 0)) {}
  GlTexture& operator=(GlTexture&&) = delete;

  /// Fills the part of `width` x `height` texels at the top left (of `layer`), rows packed.
  void upload(int width, int height, const float* texels, int layer = 0);
  void bind(int unit) const;
  GLuint id() const { return id_; }

 private:
  const GlFunctions* gl_;
  TexelFormat format_;
  GLenum target_;
  GLuint id_ = 0;
};

/// Several RGBA float targets of one size to draw into and read from.
class GlTargets {
 public:
  GlTargets(const GlFunctions& gl, int width, int height, int count);
  ~GlTargets();
  GlTargets(const GlTargets&) = delete;
  GlTargets& operator=(const GlTargets&) = delete;

  bool complete() const { return complete_; }
  const GlTexture& texture(int index) const { return textures_[static_cast<std::size_t>(index)]; }
  /// Draws one triangle over `width` x `height` pixels with the program in use.
  void draw(int width, int height);
  /// Reads `width` x `height` RGBA texels of target `index`, row 0 first.
  void read(int index, int width, int height, float* texels);

 private:
  const GlFunctions* gl_;
  std::vector<GlTexture> textures_;
  GLuint framebuffer_ = 0;
  GLuint vertices_ = 0;
  bool complete_ = false;
};

/// A linked program and its uniforms. Setting a uniform the program does not use does nothing.
class GlProgram {
 public:
  static Result<GlProgram> link(const GlFunctions& gl, const std::string& vertex_source,
                                const std::string& fragment_source);
  ~GlProgram();
  GlProgram(GlProgram&& other) noexcept : gl_(other.gl_), id_(std::exchange(other.id_, 0)) {}
  GlProgram& operator=(GlProgram&&) = delete;

  void use() const { gl_->UseProgram(id_); }
  void set(const char* name, int value) const;
  void set(const char* name, float value) const;
  void set_vec2(const char* name, const float* xy, int count = 1) const;
  void set_vec3(const char* name, const float* xyz, int count = 1) const;
  /// `rows`: nine values, row by row.
  void set_mat3(const char* name, const float* rows) const;
  void set_floats(const char* name, const float* values, int count) const;

 private:
  GlProgram(const GlFunctions& gl, GLuint id) : gl_(&gl), id_(id) {}
  GLint location(const char* name) const { return gl_->GetUniformLocation(id_, name); }
  const GlFunctions* gl_;
  GLuint id_;
};

}  // namespace pentimento
