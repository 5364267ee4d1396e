#pragma once
// The OpenGL functions the shader uses, by address. Included by the sources of shading alone.

#include <GL/glcorearb.h>

#include "core/shading/gl/context.h"

// name, type of the pointer
#define PENTIMENTO_GL_FUNCTIONS(X)                           \
  X(ActiveTexture, PFNGLACTIVETEXTUREPROC)                   \
  X(AttachShader, PFNGLATTACHSHADERPROC)                     \
  X(BindFramebuffer, PFNGLBINDFRAMEBUFFERPROC)               \
  X(BindTexture, PFNGLBINDTEXTUREPROC)                       \
  X(BindVertexArray, PFNGLBINDVERTEXARRAYPROC)               \
  X(CheckFramebufferStatus, PFNGLCHECKFRAMEBUFFERSTATUSPROC) \
  X(CompileShader, PFNGLCOMPILESHADERPROC)                   \
  X(CreateProgram, PFNGLCREATEPROGRAMPROC)                   \
  X(CreateShader, PFNGLCREATESHADERPROC)                     \
  X(DeleteFramebuffers, PFNGLDELETEFRAMEBUFFERSPROC)         \
  X(DeleteProgram, PFNGLDELETEPROGRAMPROC)                   \
  X(DeleteShader, PFNGLDELETESHADERPROC)                     \
  X(DeleteTextures, PFNGLDELETETEXTURESPROC)                 \
  X(DeleteVertexArrays, PFNGLDELETEVERTEXARRAYSPROC)         \
  X(DrawArrays, PFNGLDRAWARRAYSPROC)                         \
  X(DrawBuffers, PFNGLDRAWBUFFERSPROC)                       \
  X(FramebufferTexture2D, PFNGLFRAMEBUFFERTEXTURE2DPROC)     \
  X(GenFramebuffers, PFNGLGENFRAMEBUFFERSPROC)               \
  X(GenTextures, PFNGLGENTEXTURESPROC)                       \
  X(GenVertexArrays, PFNGLGENVERTEXARRAYSPROC)               \
  X(GetError, PFNGLGETERRORPROC)                             \
  X(GetIntegerv, PFNGLGETINTEGERVPROC)                       \
  X(GetProgramInfoLog, PFNGLGETPROGRAMINFOLOGPROC)           \
  X(GetProgramiv, PFNGLGETPROGRAMIVPROC)                     \
  X(GetShaderInfoLog, PFNGLGETSHADERINFOLOGPROC)             \
  X(GetShaderiv, PFNGLGETSHADERIVPROC)                       \
  X(GetString, PFNGLGETSTRINGPROC)                           \
  X(GetUniformLocation, PFNGLGETUNIFORMLOCATIONPROC)         \
  X(LinkProgram, PFNGLLINKPROGRAMPROC)                       \
  X(PixelStorei, PFNGLPIXELSTOREIPROC)                       \
  X(ReadBuffer, PFNGLREADBUFFERPROC)                         \
  X(ReadPixels, PFNGLREADPIXELSPROC)                         \
  X(ShaderSource, PFNGLSHADERSOURCEPROC)                     \
  X(TexImage2D, PFNGLTEXIMAGE2DPROC)                         \
  X(TexImage3D, PFNGLTEXIMAGE3DPROC)                         \
  X(TexParameteri, PFNGLTEXPARAMETERIPROC)                   \
  X(TexSubImage2D, PFNGLTEXSUBIMAGE2DPROC)                   \
  X(TexSubImage3D, PFNGLTEXSUBIMAGE3DPROC)                   \
  X(Uniform1fv, PFNGLUNIFORM1FVPROC)                         \
  X(Uniform1i, PFNGLUNIFORM1IPROC)                           \
  X(Uniform2fv, PFNGLUNIFORM2FVPROC)                         \
  X(Uniform3fv, PFNGLUNIFORM3FVPROC)                         \
  X(Uniform4fv, PFNGLUNIFORM4FVPROC)                         \
  X(UniformMatrix3fv, PFNGLUNIFORMMATRIX3FVPROC)             \
  X(UseProgram, PFNGLUSEPROGRAMPROC)                         \
  X(Viewport, PFNGLVIEWPORTPROC)

namespace pentimento {

struct GlFunctions {
#define PENTIMENTO_GL_MEMBER(name, type) type name = nullptr;
  PENTIMENTO_GL_FUNCTIONS(PENTIMENTO_GL_MEMBER)
#undef PENTIMENTO_GL_MEMBER
};

/// All of them, from a context that is current. Error: the name of the first one missing.
Result<GlFunctions> load_gl_functions(const GlContext& context);

}  // namespace pentimento
