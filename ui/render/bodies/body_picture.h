#pragma once

#include <epoxy/gl.h>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/scene.h"
#include "core/world/world.h"
#include "ui/gl/program.h"
#include "ui/render/bodies/face_buffer.h"
#include "ui/render/bodies/piece_looks.h"
#include "ui/render/bodies/prepared_body.h"
#include "ui/render/bodies/surface_textures.h"
#include "ui/render/view/frame_space.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// Loads the programs of passes from assets/shaders into the current context, and binds their blocks "Frame"
// and "Paints". Check status() after the creation of passes: after the first program that fails to load,
// all others are empty, and the passes must not draw.
class Shaders {
 public:
  Shaders();

  // Same file arguments as gl::Program::load.
  gl::Program load(const gl::ProgramFiles& files);
  const Status& status() const { return status_; }

 private:
  std::filesystem::path folder_;
  Status status_ = Done{};
};

// Binding points of the shaders' uniform blocks.
inline constexpr GLuint kFrameBlock = 0;
inline constexpr GLuint kPaintBlock = 1;
inline constexpr GLuint kSurfaceBlock = 2;

// Returns true if a buffer is bound as the uniform block of the frame; for preconditions.
bool is_frame_bound();

// One body on the GPU: its faces, its paints and the looks of its pieces.
class BodyPicture {
 public:
  // `textures` are those of the materials of its file, or null. `glow_width` [m] is that of RimDistance.
  // Precondition: `prepared` was made for this body.
  BodyPicture(const Body& body, const std::map<std::string, Paint>& paints, PreparedBody prepared,
              std::shared_ptr<const SurfaceTextures> textures, double glow_width);

  FaceBuffer& faces() { return faces_; }
  const FaceBuffer& faces() const { return faces_; }

  PieceLooks& looks() { return looks_; }
  const PieceLooks& looks() const { return looks_; }

  // Returns true if programs with TEXTURED draw it.
  bool is_textured() const { return textures_ && faces_.has_uvs(); }

  // Sets placements and paints in `program`, which is in use and draws faces.
  void bind(const gl::Program& program, const FrameSpace& space, const Placement& placement) const;
  void draw(const gl::Program& program, const FrameSpace& space, const Placement& placement) const;

 private:
  PieceLooks looks_;
  FaceBuffer faces_;
  gl::Buffer paints_;
  std::shared_ptr<const SurfaceTextures> textures_;
};

// Returns the colours (linear light) of the pieces of a body, by number from 1 on, cyclically: each is as
// far as possible from the paints of the body and from the colours before it.
std::vector<glm::dvec3> piece_colours(const std::vector<std::string>& materials,
                                      const std::map<std::string, Paint>& paints);

// Returns colour and gloss of up to 256 materials by index: of their paints, otherwise as their file
// describes them, with kDescribed added to the gloss. Any other material looks like blue-grey painted metal.
inline constexpr float kDescribed = 2;  // as in body.vert
std::vector<glm::vec4> paint_table(const std::vector<std::string>& materials,
                                   const std::map<std::string, Paint>& paints,
                                   std::span<const std::optional<SurfaceLook>> looks = {});

// While it exists, programs that write gl_ClipDistance[0] draw only the kept side of the options' section
// plane. Programs that do not write it must not draw meanwhile. No-op without a plane.
class SectionClip {
 public:
  explicit SectionClip(const ViewOptions& options) : workspace_(shown_section(options) != nullptr) {
    if (workspace_) glEnable(GL_CLIP_DISTANCE0);
  }
  ~SectionClip() {
    if (workspace_) glDisable(GL_CLIP_DISTANCE0);
  }
  SectionClip(const SectionClip&) = delete;
  SectionClip& operator=(const SectionClip&) = delete;

 private:
  bool workspace_;
};

// The input of a pass: what to draw, and with which options.
struct Subject {
  const World& world;
  std::map<BodyId, BodyPicture>& bodies;
  const FrameSpace& space;
  const ViewOptions& options;

  // The culled sides of faces.
  GLenum culled() const { return options.cull_backs ? GL_BACK : GL_NONE; }
};

// Calls visit(id, body, picture) for every body of the world that is on the GPU, in the order of ids.
template <typename Visit>
void for_each_body(const Subject& subject, const Visit& visit) {
  for (auto& [id, picture] : subject.bodies) {
    if (subject.world.contains(id)) visit(id, subject.world.body(id), picture);
  }
}

// Draws the bodies with a program that is in use.
inline void draw_bodies(const Subject& subject, const gl::Program& program) {
  for_each_body(subject, [&](BodyId, const Body& body, const BodyPicture& picture) {
    picture.draw(program, subject.space, body.placement);
  });
}

}  // namespace kerf
