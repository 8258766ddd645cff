#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"

namespace kerf::gl {

// An OpenGL 3.3 core context without a window, a screen or an X server. It is current on this thread while
// the object exists. It has no default framebuffer.
class OffscreenContext {
 public:
  // Tries EGL's surfaceless platform and then its first device. The error says why each of them failed.
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
