#include "ui/gl/debug_output.h"

#include <epoxy/gl.h>

#include <cstdio>
#include <cstdlib>

#include "core/base/assert.h"

namespace kerf::gl {

namespace {

void fail(GLenum, GLenum type, GLuint, GLenum severity, GLsizei, const GLchar* text, const void*) {
  if (type != GL_DEBUG_TYPE_ERROR && severity != GL_DEBUG_SEVERITY_HIGH) return;
  std::fprintf(stderr, "OpenGL: %s\n", text);
  std::abort();
}

}  // namespace

void report_gl_errors() {
  if (!asserts_are_fatal() || !epoxy_has_gl_extension("GL_KHR_debug")) return;
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(fail, nullptr);
}

}  // namespace kerf::gl
