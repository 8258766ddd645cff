#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/document/scene.h"
#include "core/world/world.h"
#include "ui/gl/program.h"
#include "ui/render/face_buffer.h"
#include "ui/render/frame_space.h"
#include "ui/render/piece_looks.h"
#include "ui/render/prepared_body.h"

namespace kerf {

// The uniform blocks of the shaders.
inline constexpr GLuint kFrameBlock = 0;
inline constexpr GLuint kPaintBlock = 1;

// One body as it is drawn: its faces and its paints.
class BodyPicture {
 public:
  // `prepared` is of the body as it was loaded.
  BodyPicture(const Body& body, const std::map<std::string, Paint>& paints, PreparedBody prepared);

  FaceBuffer& faces() { return faces_; }
  const FaceBuffer& faces() const { return faces_; }

  PieceLooks& looks() { return looks_; }
  const PieceLooks& looks() const { return looks_; }

  // With a program in use whose vertices are faces': where the body and its pieces stand, its paints.
  void bind(const gl::Program& program, const FrameSpace& space, const Placement& placement) const;
  // That and its faces.
  void draw(const gl::Program& program, const FrameSpace& space, const Placement& placement) const;

 private:
  PieceLooks looks_;
  FaceBuffer faces_;
  gl::Buffer paints_;
};

// The colour and gloss of up to 256 materials by index; what has no paint looks like blue-grey painted metal.
std::vector<glm::vec4> paint_table(const std::vector<std::string>& materials,
                                   const std::map<std::string, Paint>& paints);

}  // namespace kerf
