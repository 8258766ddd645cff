#pragma once

#include <memory>

#include "core/base/result.h"

namespace kerf::gl {

// Where assertions are fatal (core/base/assert.h), so is each error that the driver reports for the context
// that is current: it is printed on standard error, and the program ends by a signal. Does nothing elsewhere,
// or where the context has no debug output.
void report_gl_errors();

// An OpenGL 3.3 core context without a window, a screen or an X server. It is current on this thread while
// the object exists. It has a default framebuffer only where it was created with a surface.
class OffscreenContext {
 public:
  // Tries EGL's surfaceless platform and then its first device. The error says why each of them failed.
  static Result<OffscreenContext> create();
  // Creates a context whose default framebuffer is a surface in memory of a size in pixels. Precondition: the
  // size is positive.
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
