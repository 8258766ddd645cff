#pragma once

#include <optional>
#include <vector>

#include "ui/gl/framebuffer.h"
#include "ui/render/bodies/shaders.h"
#include "ui/render/passes/ground_pass.h"
#include "ui/render/shadow/shadow_pass.h"

namespace kerf {

// For each pixel of a picture the visible face and the stencil count of a shadow. Rows start at the bottom.
struct ShadowCounts {
  int width = 0, height = 0;
  std::vector<uint32_t> faces;   // lower 24 bits: slot; upper 8: number of the body from 1; 0: sky
  std::vector<uint8_t> stencil;  // lit where 0

  static constexpr uint32_t kGround = 0xff000000u;
  static uint32_t mark(uint32_t body, uint32_t slot) { return (body % 127 + 1) << 24 | (slot & 0xffffffu); }
};

// Renders the visible faces and the stencil counts with one sample per pixel and reads both back.
class ShadowProbe {
 public:
  explicit ShadowProbe(Shaders& shaders);

  // If `ground` is null, only bodies are visible. Changes the bound framebuffer. Precondition: the uniform
  // block of the frame is bound and matches the size, which is positive.
  ShadowCounts look(const Subject& subject, ShadowPass& shadows, size_t light, ShadowMethod method,
                    const GroundPass* ground, int width, int height);

 private:
  void draw_marks(const Subject& subject, const GroundPass* ground) const;

  gl::Program faces_, ground_;
  std::optional<gl::Framebuffer> picture_;
};

// The number of pixels that are lit in only one of two pictures. Precondition: they have the same size.
size_t differing_pixels(const ShadowCounts& a, const ShadowCounts& b);

}  // namespace kerf
