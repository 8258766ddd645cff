#pragma once

#include <optional>

#include "ui/gl/framebuffer.h"
#include "ui/gl/stream.h"
#include "ui/render/bodies/face_labels.h"
#include "ui/render/bodies/shaders.h"
#include "ui/render/bodies/subject.h"

namespace kerf {

// Draws the numbers of faces, including removed ones, over the picture. The faces are drawn into an
// off-screen picture of face numbers that is read back, so that each number lies on its face.
class FaceNumbers {
 public:
  explicit FaceNumbers(Shaders& shaders);

  // Draws over `picture` and leaves it bound. O(faces).
  void draw(const Subject& subject, const FrameUniforms& frame, const gl::Framebuffer& picture);

  // Draws any numbers over the bound framebuffer, each with its lower left corner at a given pixel.
  void draw_labels(const std::vector<FaceLabel>& labels, int zoom);

 private:
  struct Glyph {
    glm::vec2 place, style;
  };
  void make_bitmaps();
  // The visible faces, four bytes per pixel as written by faces.vert.
  std::vector<uint8_t> look_which(const Subject& subject, int width, int height);

  gl::Program faces_, removed_, numbers_;
  std::optional<gl::Framebuffer> which_;
  gl::Texture bitmaps_;
  gl::Stream<Glyph> glyphs_{gl::ItemsAre::kInstances, {{2, 0}, {2, sizeof(glm::vec2)}}};
};

}  // namespace kerf
