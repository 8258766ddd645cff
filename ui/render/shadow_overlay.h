#pragma once

#include <span>

#include "ui/gl/framebuffer.h"
#include "ui/render/face_numbers.h"
#include "ui/render/shadow_pass.h"

namespace kerf {

// What shadow volumes are made of, over a picture: the silhouette of a light in blue, lighter and thinner
// where one side lies on an edge, stronger where two do, violet where more; the volumes as sheets and wire,
// blue where they are seen from outside and orange where from within; the counts of the stencil as a heat
// map; polygons that face the light in a pale yellow and averted ones in dark blue. Strips at the lower left
// say which colour means which number.
class ShadowOverlay {
 public:
  static Result<ShadowOverlay> create(const std::filesystem::path& shaders);

  // Over a picture with its depth, which stays; its stencil does not. For the light that the options inspect.
  void draw(const Subject& subject, ShadowPass& shadows, const FaceNumbers& numbers,
            const gl::Framebuffer& picture) const;

 private:
  ShadowOverlay(gl::Program line, gl::Program sheet, gl::Program facing, gl::Program solid);

  struct Inspected;
  void draw_facing(const Inspected& seen) const;
  void draw_counts(const Inspected& seen, const FaceNumbers& numbers) const;
  void draw_volumes(const Inspected& seen) const;
  void draw_silhouette(const Inspected& seen, const FaceNumbers& numbers) const;
  void draw_lines(const Inspected& seen, float half_width, float reach,
                  std::span<const glm::vec4> colours) const;

  gl::Program line_, sheet_, facing_, solid_;
  gl::VertexArray no_vertices_;
};

}  // namespace kerf
