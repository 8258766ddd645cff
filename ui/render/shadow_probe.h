#pragma once

#include <optional>
#include <vector>

#include "ui/gl/framebuffer.h"
#include "ui/render/ground_pass.h"
#include "ui/render/shadow_pass.h"

namespace kerf {

// What the pixels of a picture show and how the GPU counted the shadow on them. Rows from below.
struct ShadowCounts {
  int width = 0, height = 0;
  std::vector<uint32_t> faces;  // slot, 24 bits, and the number of the body from 1 in the upper 8; 0: the sky
  std::vector<uint8_t> stencil;  // lit where 0

  static constexpr uint32_t kGround = 0xff000000u;
  static uint32_t mark(uint32_t body, uint32_t slot) { return (body % 127 + 1) << 24 | (slot & 0xffffffu); }
};

// Draws which face every pixel shows, counts its shadow as the picture does, and reads both back. One sample.
class ShadowProbe {
 public:
  static Result<ShadowProbe> create(const std::filesystem::path& shaders);

  // The uniform block of the frame must be bound and fit the size. Without `ground` only bodies are seen.
  // Changes what is bound.
  ShadowCounts look(const Subject& subject, ShadowPass& shadows, size_t light, ShadowMethod method,
                    const GroundPass* ground, int width, int height);

 private:
  ShadowProbe(gl::Program faces, gl::Program ground);
  void draw_marks(const Subject& subject, const GroundPass* ground) const;

  gl::Program faces_, ground_;
  std::optional<gl::Framebuffer> picture_;
};

// Pixels of one size that are lit in one and not in the other.
size_t differing_pixels(const ShadowCounts& a, const ShadowCounts& b);

}  // namespace kerf
