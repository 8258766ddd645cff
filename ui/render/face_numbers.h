#pragma once

#include <optional>

#include "ui/gl/framebuffer.h"
#include "ui/gl/program.h"
#include "ui/render/face_labels.h"
#include "ui/render/subject.h"

namespace kerf {

// The numbers of faces over the picture, those of faces that are gone included. Which face shows where is
// drawn into a picture of its own and read back, so a number stands only on its face.
class FaceNumbers {
 public:
  static Result<FaceNumbers> create(const std::filesystem::path& shaders);

  // Over the picture, which is bound again after. O(faces).
  void draw(const Subject& subject, const FrameUniforms& frame, const gl::Framebuffer& picture);

  // Any numbers over what is bound, each with its lower left corner at a pixel of it.
  void draw_labels(const std::vector<FaceLabel>& labels, int zoom) const;

 private:
  FaceNumbers(gl::Program faces, gl::Program removed, gl::Program numbers);
  void make_bitmaps();
  // Four bytes a pixel, as faces.vert marks them.
  std::vector<uint8_t> look_which(const Subject& subject, int width, int height);

  gl::Program faces_, removed_, numbers_;
  std::optional<gl::Framebuffer> which_;
  gl::Texture bitmaps_;
  gl::Buffer glyphs_;
  gl::VertexArray layout_;
};

}  // namespace kerf
