#include "ui/gl/debug_output.h"

#include <epoxy/gl.h>

#include <cstdio>

namespace kerf::gl {

#ifndef NDEBUG
namespace {

void print(GLenum, GLenum type, GLuint, GLenum severity, GLsizei, const GLchar* text, const void*) {
  if (type != GL_DEBUG_TYPE_ERROR && severity != GL_DEBUG_SEVERITY_HIGH) return;
  std::fprintf(stderr, "OpenGL: %s\n", text);
}

}  // namespace
#endif

void report_gl_errors() {
#ifndef NDEBUG
  if (!epoxy_has_gl_extension("GL_KHR_debug")) return;
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(print, nullptr);
#endif
}

}  // namespace kerf::gl
