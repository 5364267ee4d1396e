#include "core/shading/gl/objects.h"

#include <array>

namespace pentimento {
namespace {

GLenum layout(TexelFormat f) {
  constexpr GLenum kLayout[] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
  return kLayout[static_cast<int>(f)];
}
GLint storage(TexelFormat f) {
  constexpr GLint kStorage[] = {GL_R32F, GL_RG32F, GL_RGB32F, GL_RGBA32F};
  return kStorage[static_cast<int>(f)];
}

std::string compile(const GlFunctions& gl, GLuint shader, const std::string& source) {
  const char* text = source.c_str();
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  GLint ok = GL_FALSE;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok == GL_TRUE) return {};
  std::array<char, 2000> log{};
  gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  return std::string("shader: ") + log.data();
}

std::string link_error(const GlFunctions& gl, GLuint program) {
  gl.LinkProgram(program);
  GLint ok = GL_FALSE;
  gl.GetProgramiv(program, GL_LINK_STATUS, &ok);
  if (ok == GL_TRUE) return {};
  std::array<char, 2000> log{};
  gl.GetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
  return std::string("shader program: ") + log.data();
}

}  // namespace

GlTexture::GlTexture(const GlFunctions& gl, TexelFormat format, int width, int height, int layers,
                     bool filtered)
    : gl_(&gl), format_(format), target_(layers > 0 ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D) {
  gl.GenTextures(1, &id_);
  gl.BindTexture(target_, id_);
  const GLint filter = filtered ? GL_LINEAR : GL_NEAREST;
  gl.TexParameteri(target_, GL_TEXTURE_MIN_FILTER, filter);
  gl.TexParameteri(target_, GL_TEXTURE_MAG_FILTER, filter);
  gl.TexParameteri(target_, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(target_, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  if (layers > 0) {
    gl.TexImage3D(target_, 0, storage(format), width, height, layers, 0, layout(format), GL_FLOAT,
                  nullptr);
  } else {
    gl.TexImage2D(target_, 0, storage(format), width, height, 0, layout(format), GL_FLOAT, nullptr);
  }
}

GlTexture::~GlTexture() {
  if (id_ != 0) gl_->DeleteTextures(1, &id_);
}

void GlTexture::upload(int width, int height, const float* texels, int layer) {
  gl_->BindTexture(target_, id_);
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  if (target_ == GL_TEXTURE_2D_ARRAY) {
    gl_->TexSubImage3D(target_, 0, 0, 0, layer, width, height, 1, layout(format_), GL_FLOAT,
                       texels);
  } else {
    gl_->TexSubImage2D(target_, 0, 0, 0, width, height, layout(format_), GL_FLOAT, texels);
  }
}

void GlTexture::bind(int unit) const {
  gl_->ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl_->BindTexture(target_, id_);
}

GlTargets::GlTargets(const GlFunctions& gl, int width, int height, int count) : gl_(&gl) {
  gl.GenVertexArrays(1, &vertices_);
  gl.GenFramebuffers(1, &framebuffer_);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  std::vector<GLenum> buffers;
  for (int i = 0; i < count; ++i) {
    textures_.emplace_back(gl, TexelFormat::kRgba, width, height);
    buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, buffers.back(), GL_TEXTURE_2D, textures_.back().id(),
                            0);
  }
  gl.DrawBuffers(count, buffers.data());
  complete_ = gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

GlTargets::~GlTargets() {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl_->DeleteFramebuffers(1, &framebuffer_);
  gl_->DeleteVertexArrays(1, &vertices_);
}

void GlTargets::draw(int width, int height) {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_->BindVertexArray(vertices_);
  gl_->Viewport(0, 0, width, height);
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
}

void GlTargets::read(int index, int width, int height, float* texels) {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_->ReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(index));
  gl_->PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl_->ReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, texels);
}

Result<GlProgram> GlProgram::link(const GlFunctions& gl, const std::string& vertex_source,
                                  const std::string& fragment_source) {
  GlProgram program(gl, gl.CreateProgram());
  const GLuint vertex = gl.CreateShader(GL_VERTEX_SHADER);
  const GLuint fragment = gl.CreateShader(GL_FRAGMENT_SHADER);
  std::string error = compile(gl, vertex, vertex_source);
  if (error.empty()) error = compile(gl, fragment, fragment_source);
  if (error.empty()) {
    gl.AttachShader(program.id_, vertex);
    gl.AttachShader(program.id_, fragment);
    error = link_error(gl, program.id_);
  }
  gl.DeleteShader(vertex);
  gl.DeleteShader(fragment);
  if (!error.empty()) return Error{ErrorCode::kIo, error};
  return program;
}

GlProgram::~GlProgram() {
  if (id_ != 0) gl_->DeleteProgram(id_);
}

void GlProgram::set(const char* name, int value) const {
  gl_->Uniform1i(location(name), value);
}
void GlProgram::set(const char* name, float value) const {
  gl_->Uniform1fv(location(name), 1, &value);
}
void GlProgram::set_vec2(const char* name, const float* xy, int count) const {
  gl_->Uniform2fv(location(name), count, xy);
}
void GlProgram::set_vec3(const char* name, const float* xyz, int count) const {
  gl_->Uniform3fv(location(name), count, xyz);
}
void GlProgram::set_mat3(const char* name, const float* rows) const {
  gl_->UniformMatrix3fv(location(name), 1, GL_TRUE, rows);
}
void GlProgram::set_floats(const char* name, const float* values, int count) const {
  gl_->Uniform1fv(location(name), count, values);
}

}  // namespace pentimento
