#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"

namespace kerf::gl {

// If assertions are fatal (core/base/assert.h), makes each error that the driver reports for the current
// context fatal: prints it on standard error, and ends the program by a signal. Otherwise, or if the context
// has no debug output, does nothing.
void report_gl_errors();

// Stops report_gl_errors() for the current context, until its next call.
void ignore_gl_errors();

// Returns the name of the renderer of the current context, such as "llvmpipe (LLVM 15.0.6, 256 bits)".
std::string renderer_name();

// An OpenGL 3.3 core context without a window, a screen or an X server. Current on this thread while the
// object exists. Has a default framebuffer only if it was created with a surface.
class OffscreenContext {
 public:
  // Tries EGL's surfaceless platform, then its first device. The error gives the reason for each failure.
  static Result<OffscreenContext> create();
  // Creates a context whose default framebuffer is an off-screen surface. Precondition: the size [pixels] is
  // positive.
  static Result<OffscreenContext> create_with_surface(int width, int height);
  // Replaces the surface by one of another size, with undefined content. Precondition: there is a surface
  // and the size is positive.
  void resize_surface(int width, int height);

  ~OffscreenContext();
  OffscreenContext(OffscreenContext&&) noexcept;
  OffscreenContext& operator=(OffscreenContext&&) noexcept;

 private:
  struct Handles;
  explicit OffscreenContext(std::unique_ptr<Handles> handles);
  static Result<std::unique_ptr<Handles>> open(bool with_surface);
  bool put_surface(int width, int height);
  std::unique_ptr<Handles> handles_;
};

}  // namespace kerf::gl
