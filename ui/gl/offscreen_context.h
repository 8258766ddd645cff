#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"

namespace kerf::gl {

// An OpenGL 3.3 core context without window, screen or X server, current on this thread while it lives. There
// is no default framebuffer: draw into one of your own.
class OffscreenContext {
 public:
  // Tries EGL's surfaceless platform, then its first device; the error names both and why they failed.
  static Result<OffscreenContext> create();

  ~OffscreenContext();
  OffscreenContext(OffscreenContext&&) noexcept;
  OffscreenContext& operator=(OffscreenContext&&) noexcept;

 private:
  struct Handles;
  explicit OffscreenContext(std::unique_ptr<Handles> handles);
  std::unique_ptr<Handles> handles_;
};

}  // namespace kerf::gl
