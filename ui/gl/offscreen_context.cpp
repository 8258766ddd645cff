#include "ui/gl/offscreen_context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

namespace kerf::gl {

struct OffscreenContext::Handles {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  ~Handles() {
    if (display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    eglTerminate(display);
  }
};

namespace {

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

// Null when it worked, else the step that did not.
const char* open_context(EGLDisplay display, EGLContext& context) {
  if (display == EGL_NO_DISPLAY) return "not offered";
  if (!eglInitialize(display, nullptr, nullptr)) return "does not initialise";
  if (!eglBindAPI(EGL_OPENGL_API)) return "has no desktop OpenGL";
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
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

Result<OffscreenContext> OffscreenContext::create() {
  std::string reasons;
  const auto attempt = [&](const char* name, EGLDisplay display) -> std::unique_ptr<Handles> {
    auto handles = std::make_unique<Handles>();
    handles->display = display;
    const char* trouble = open_context(display, handles->context);
    if (trouble == nullptr) return handles;
    reasons += std::string(reasons.empty() ? "" : ", ") + name + " " + trouble;
    return nullptr;
  };
  if (auto handles = attempt("EGL's surfaceless platform", surfaceless_display())) {
    return OffscreenContext(std::move(handles));
  }
  if (auto handles = attempt("EGL's device platform", device_display())) {
    return OffscreenContext(std::move(handles));
  }
  return failed("OpenGL cannot be had without a screen: " + reasons +
                "; install libegl1 and libgl1-mesa-dri");
}

OffscreenContext::OffscreenContext(std::unique_ptr<Handles> handles) : handles_(std::move(handles)) {}
OffscreenContext::~OffscreenContext() = default;
OffscreenContext::OffscreenContext(OffscreenContext&&) noexcept = default;
OffscreenContext& OffscreenContext::operator=(OffscreenContext&&) noexcept = default;

}  // namespace kerf::gl
