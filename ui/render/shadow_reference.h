#pragma once

#include <optional>
#include <vector>

#include "core/shadow/shadow_rays.h"
#include "ui/render/lit_scene.h"

namespace kerf {

// For each pixel of a frame, the visible face and the stencil count of a shadow. Rows start at the bottom.
struct ShadowCounts {
  int width = 0, height = 0;
  std::vector<uint32_t> faces;   // lower 24 bits: slot; upper 8: number of the body from 1; 0: sky
  std::vector<uint8_t> stencil;  // 0: lit

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

// Returns the number of pixels that are lit in only one of two frames. Precondition: they have the same
// size.
size_t differing_pixels(const ShadowCounts& a, const ShadowCounts& b);

// Returns a ray tracer for the drawn scene: all bodies in the order of their ids, pieces at their drawn
// positions.
ShadowRays rays_through(const Subject& subject);

// Traces the shadows of a frame pixel by pixel, in rows from the bottom, over several calls.
class ShadowReference {
 public:
  // `near`: distance of the near plane along the view's forward axis, m; `ground`: its height [m] if it is
  // visible and receives shadows. The side cut away by `section` is invisible but casts shadows.
  // Precondition: the size is positive.
  ShadowReference(ShadowRays rays, const CameraView& view, double near,
                  const std::optional<SectionPlane>& section, const Light& light,
                  std::optional<double> ground, int width, int height);

  // Traces whole rows, at least `pixels` pixels or all that are left.
  void trace(size_t pixels);
  bool done() const { return row_ == height_; }
  double share_done() const { return static_cast<double>(row_) / height_; }

  int width() const { return width_; }
  int height() const { return height_; }
  // For each pixel the visible face as in ShadowCounts::faces and the number of surfaces that occlude the
  // light; 0 in rows not traced yet.
  const std::vector<uint32_t>& faces() const { return faces_; }
  const std::vector<int>& occluders() const { return occluders_; }

 private:
  std::optional<ShadowRays::Seen> look(const Pose& ray) const;
  void trace_pixel(int x, int y);

  ShadowRays rays_;
  CameraView view_;
  double near_;
  std::optional<SectionPlane> section_;
  Light light_;
  std::optional<double> ground_;
  int width_, height_, row_ = 0;
  std::vector<uint32_t> faces_;
  std::vector<int> occluders_;
};

// Returns the number of pixels that show the same face in both and are lit in only one. Ignores rows not
// traced yet. Precondition: they have the same size.
size_t differing_pixels(const ShadowCounts& drawn, const ShadowReference& traced);

// Draws ray-traced shadows over a frame: dark if the light is occluded, pale if not, and magenta if the
// shadow volumes, counted with one sample per pixel, disagree. Rows not traced yet stay unchanged.
class ReferencePass {
 public:
  explicit ReferencePass(Shaders& shaders);

  // Draws over the whole bound framebuffer. Precondition: `traced` and `drawn` have the same size.
  void draw(const ShadowReference& traced, const ShadowCounts& drawn) const;

 private:
  gl::Program overlay_;
  gl::Texture picture_;
  gl::NoVertices no_vertices_;
};

}  // namespace kerf
