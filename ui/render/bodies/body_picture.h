#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/document/files/scene.h"
#include "core/world/world.h"
#include "ui/gl/program.h"
#include "ui/render/bodies/face_buffer.h"
#include "ui/render/bodies/piece_looks.h"
#include "ui/render/bodies/prepared_body.h"
#include "ui/render/view/frame_space.h"

namespace kerf {

// Binding points of the shaders' uniform blocks.
inline constexpr GLuint kFrameBlock = 0;
inline constexpr GLuint kPaintBlock = 1;

// Whether a buffer is bound as the uniform block of the frame, as a precondition.
bool is_frame_bound();

// One body on the GPU: its faces, its paints and the looks of its pieces.
class BodyPicture {
 public:
  // `glow_width` (m) is that of RimDistance. Precondition: `prepared` was made for this body.
  BodyPicture(const Body& body, const std::map<std::string, Paint>& paints, PreparedBody prepared,
              double glow_width);

  FaceBuffer& faces() { return faces_; }
  const FaceBuffer& faces() const { return faces_; }

  PieceLooks& looks() { return looks_; }
  const PieceLooks& looks() const { return looks_; }

  // Sets placements and paints in `program`, which is in use and draws faces.
  void bind(const gl::Program& program, const FrameSpace& space, const Placement& placement) const;
  // Binds and draws the faces.
  void draw(const gl::Program& program, const FrameSpace& space, const Placement& placement) const;

 private:
  PieceLooks looks_;
  FaceBuffer faces_;
  gl::Buffer paints_;
};

// The colours (linear light) of the pieces of a body, by their numbers from 1 on, over and over: each as far
// as possible from the paints of the body and from the colours before it.
std::vector<glm::dvec3> piece_colours(const std::vector<std::string>& materials,
                                      const std::map<std::string, Paint>& paints);

// Colour and gloss of up to 256 materials by index. A material without a paint looks like blue-grey painted
// metal.
std::vector<glm::vec4> paint_table(const std::vector<std::string>& materials,
                                   const std::map<std::string, Paint>& paints);

}  // namespace kerf
