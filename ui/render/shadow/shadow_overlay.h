#pragma once

#include <span>

#include "ui/gl/framebuffer.h"
#include "ui/render/bodies/shaders.h"
#include "ui/render/passes/face_numbers.h"
#include "ui/render/shadow/shadow_pass.h"

namespace kerf {

// Draws the construction of shadow volumes over a picture: the silhouette in blue, thin and light for
// multiplicity 1, stronger for 2 and violet above; the volumes as sheets and wire, blue from outside and
// orange from inside; the stencil counts as a heat map; polygons that face the light in pale yellow and those
// that face away in dark blue. A legend at the lower left explains the colours.
class ShadowOverlay {
 public:
  explicit ShadowOverlay(Shaders& shaders);

  // Draws for the light that the options inspect, over a picture whose depth is kept; its stencil is
  // overwritten.
  void draw(const Subject& subject, ShadowPass& shadows, FaceNumbers& numbers,
            const gl::Framebuffer& picture) const;

 private:
  struct Inspected;
  void draw_facing(const Inspected& seen) const;
  void draw_counts(const Inspected& seen, FaceNumbers& numbers) const;
  void draw_volumes(const Inspected& seen) const;
  void draw_silhouette(const Inspected& seen, FaceNumbers& numbers) const;
  void draw_lines(const Inspected& seen, float half_width, float reach,
                  std::span<const glm::vec4> colours) const;

  gl::Program line_, sheet_, facing_, solid_;
  gl::NoVertices no_vertices_;
};

}  // namespace kerf
