#include "ui/gl/context.h"

#include <epoxy/egl.h>
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

EGLDisplay surfaceless_display() {
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) return EGL_NO_DISPLAY;
  return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
}

EGLDisplay device_display() {
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration")) return EGL_NO_DISPLAY;
  EGLDeviceEXT device = nullptr;
  EGLint count = 0;
  if (!eglQueryDevicesEXT(1, &device, &count) || count == 0) return EGL_NO_DISPLAY;
  return eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
}

// Returns null on success, else the failed step. A surface requires the depth and stencil of a window.
const char* open_context(EGLDisplay display, bool with_surface, EGLConfig& config, EGLContext& context) {
  if (display == EGL_NO_DISPLAY) return "is not available";
  if (!eglInitialize(display, nullptr, nullptr)) return "does not initialise";
  if (!eglBindAPI(EGL_OPENGL_API)) return "has no desktop OpenGL";
  const EGLint wanted[] = {EGL_SURFACE_TYPE,     EGL_PBUFFER_BIT,      EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,       EGL_RED_SIZE,         with_surface ? 8 : 0,
                           EGL_GREEN_SIZE,       with_surface ? 8 : 0, EGL_BLUE_SIZE,
                           with_surface ? 8 : 0, EGL_DEPTH_SIZE,       with_surface ? 24 : 0,
                           EGL_STENCIL_SIZE,     with_surface ? 8 : 0, EGL_NONE};
  EGLint configs = 0;
  if (!eglChooseConfig(display, wanted, &config, 1, &configs) || configs == 0) return "has no configuration";
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                            3,
                            EGL_CONTEXT_MINOR_VERSION,
                            3,
                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                            EGL_NONE};
  context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
  if (context == EGL_NO_CONTEXT) return "has no OpenGL 3.3";
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
    return "cannot draw without a surface";
  return nullptr;
}

}  // namespace

std::string renderer_name() {
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return name != nullptr ? name : "unknown";
}

void report_gl_errors() {
  if (!asserts_are_fatal() || !epoxy_has_gl_extension("GL_KHR_debug")) return;
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(fail, nullptr);
}

void ignore_gl_errors() {
  if (asserts_are_fatal() && epoxy_has_gl_extension("GL_KHR_debug")) glDisable(GL_DEBUG_OUTPUT);
}

struct OffscreenContext::Handles {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLConfig config = nullptr;
  EGLContext context = EGL_NO_CONTEXT;
  EGLSurface surface = EGL_NO_SURFACE;
  ~Handles() {
    if (display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (surface != EGL_NO_SURFACE) eglDestroySurface(display, surface);
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    eglTerminate(display);
  }
};

Result<std::unique_ptr<OffscreenContext::Handles>> OffscreenContext::open(bool with_surface) {
  std::string reasons;
  const auto attempt = [&](const char* name, EGLDisplay display) -> std::unique_ptr<Handles> {
    auto handles = std::make_unique<Handles>();
    handles->display = display;
    const char* trouble = open_context(display, with_surface, handles->config, handles->context);
    if (trouble == nullptr) return handles;
    reasons += std::string(reasons.empty() ? "" : ", ") + name + " " + trouble;
    return nullptr;
  };
  if (auto handles = attempt("EGL's surfaceless platform", surfaceless_display())) return handles;
  if (auto handles = attempt("EGL's device platform", device_display())) return handles;
  return failed("Cannot create an OpenGL context: " + reasons + "; install libegl1 and libgl1-mesa-dri");
}

Result<OffscreenContext> OffscreenContext::create() {
  auto handles = open(false);
  if (!handles) return handles.error();
  report_gl_errors();
  return OffscreenContext(std::move(*handles));
}

Result<OffscreenContext> OffscreenContext::create_with_surface(int width, int height) {
  auto handles = open(true);
  if (!handles) return handles.error();
  OffscreenContext context(std::move(*handles));
  if (!context.put_surface(width, height)) return failed("Cannot create an off-screen OpenGL surface");
  report_gl_errors();
  return context;
}

void OffscreenContext::resize_surface(int width, int height) {
  KERF_ASSERT(handles_->surface != EGL_NO_SURFACE);
  const bool there = put_surface(width, height);
  KERF_ASSERT(there);
}

bool OffscreenContext::put_surface(int width, int height) {
  KERF_ASSERT(width > 0 && height > 0);
  const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
  EGLSurface surface = eglCreatePbufferSurface(handles_->display, handles_->config, size);
  if (surface == EGL_NO_SURFACE || !eglMakeCurrent(handles_->display, surface, surface, handles_->context))
    return false;
  if (handles_->surface != EGL_NO_SURFACE) eglDestroySurface(handles_->display, handles_->surface);
  handles_->surface = surface;
  return true;
}

OffscreenContext::OffscreenContext(std::unique_ptr<Handles> handles) : handles_(std::move(handles)) {}
OffscreenContext::~OffscreenContext() = default;
OffscreenContext::OffscreenContext(OffscreenContext&&) noexcept = default;
OffscreenContext& OffscreenContext::operator=(OffscreenContext&&) noexcept = default;

}  // namespace kerf::gl
